"""draw_animations.py - draws the frames of animations, and makes videos of them.

    draw_animations.py FOLDER NAME...                           of the scripts FOLDER/NAME/NAME.gp
    draw_animations.py FOLDER --turn NAME SCENE.nff PROGRAM...  PROGRAM casts a frame, --turn DEGREES

In the environment: FORMAT (mp4, webm, gif, apng, png), THEME (light, dark), as lists with commas. gnuplot draws a
frame for each step of a script, FOLDER/NAME/frames[-dark]/0001.png and so on; the steps at which a lecturer stops are
also steps[-dark]/01.png and so on; the videos are FOLDER/NAME/NAME[-dark].FORMAT. As many processes run as there are
processors. If the script is the same, a frame that is there is not drawn again. ffmpeg works with one thread and
writes no dates, so the same frames give the same bytes. Exit status: 1 if something could not be made, 2 wrong usage,
3 a program is missing.
"""
import os
import shutil
import sys
from pathlib import Path

sys.path.append("chapters/gallery")
from jobs import beside_each_other, end_with_programs, is_newer, run, wanted  # noqa: E402 - found from there on

TURNS, TURN_SECONDS = 90, 6
MOST_BYTES = 3000000

# Frames are RGB, and videos have the colors of HDTV. A story rests on its last frame; a turntable does not.
VIDEO = "scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int,format=yuv420p"
RESTING = f"tpad=stop_mode=clone:stop_duration=2,{VIDEO}"
HDTV = "-colorspace bt709 -color_primaries bt709 -color_trc bt709"
# 128 colors, of which flat drawings need few. A turntable has no two equal pixels, so it has fewer pictures, smoothed
# a little, in so few colors that it has less than 3 MB. Its frames may be PNGs of two kinds, with and without a
# palette, so all become RGB.
IN_COLORS = "split[a][b];[a]palettegen=max_colors={}[p];[b][p]paletteuse=dither=none:diff_mode=rectangle"
SMALLER = f"scale,format=rgb24,fps=3,median=radius=1,{IN_COLORS}"
# The encoder of ffmpeg; the filter of a story, and of a turntable; the settings, and those that a turntable has beside
# them: 6 s in less than 3 MB.
FORMATS = {
    "mp4": ("libx264", RESTING, VIDEO, f"-preset slow -crf 24 -g 60 -movflags +faststart {HDTV}",
            "-maxrate 3400k -bufsize 3400k"),
    "webm": ("libvpx-vp9", RESTING, VIDEO, f"-crf 36 -b:v 0 -deadline good -cpu-used 3 -g 60 {HDTV}", "-b:v 3200k"),
    "gif": ("gif", IN_COLORS.format(128), SMALLER.format(28), "-loop 0 -final_delay 200", "-final_delay -1"),
    "apng": ("apng", IN_COLORS.format(128), SMALLER.format(64), "-plays 0 -final_delay 2", "-final_delay 1/3"),
    "png": (None, None, None, None, None),
}


def fail(words, status=1):
    print(words, file=sys.stderr)
    sys.exit(status)


def in_words(said):
    return said.decode("utf-8", "replace")


class Animation:
    """In one theme. cast: the program that casts a frame of a turntable, and its arguments; without it, gnuplot draws
    the script 'source'."""

    def __init__(self, folder, name, theme, source=None, cast=()):
        self.theme, self.suffix = theme, "-dark" if theme == "dark" else ""
        self.home, self.name = folder / name, name + self.suffix
        self.frames = self.home / f"frames{self.suffix}"
        self.source, self.cast, self.stops = source or self.home / f"{name}.gp", cast, []
        if cast:
            self.count = turns()
            self.rate = max(1, self.count // TURN_SECONDS)
        else:
            self.ask_script(name)

    def ask_script(self, name):
        """How many steps it has, how fast they go, and at which a lecturer stops."""
        status, said = run(["gnuplot", "-d", "-e", f"format='txt'; output='{self.home}/{name}'", str(self.source),
                            "-e", "set print '-'; print steps, rate; print stops"])
        if status != 0:
            fail(f"{in_words(said)}{self.source}: gnuplot cannot draw it")
        try:
            self.count, self.rate, *self.stops = map(int, said.split())
        except ValueError:
            self.count = self.rate = 0
        if not (1 <= self.count <= 9999 and self.rate >= 1):
            fail(f"{self.source}: expected steps and a rate, both greater than 0")

    def frame(self, number):
        return self.frames / f"{number:04}.png"

    def draw_frame(self, number):
        """Under another name first, so that half a frame is never taken for one."""
        new = self.frames / f".{number:04}"
        if self.cast:
            command = [*self.cast, "--turn", f"{360 * (number - 1) / self.count:.10g}", "-o", f"{new}.png", str(self.source)]
        else:
            command = ["gnuplot", "-d", "-e", f"format='png'; theme='{self.theme}'; step={number}; output='{new}'",
                       str(self.source)]
        status, said = run(command)
        drawn = Path(f"{new}.png")
        if status == 0 and drawn.exists():
            drawn.replace(self.frame(number))
            return ""
        drawn.unlink(missing_ok=True)
        return f"{in_words(said)}{self.name}: frame {number} of {self.count} was not drawn"

    def draw_frames(self):
        """Draws those that are missing; whether there were any."""
        self.frames.mkdir(exist_ok=True)
        copy = self.frames / ".source"
        if not copy.exists() or copy.read_bytes() != self.source.read_bytes():
            shutil.copyfile(self.source, copy)
        sources = [copy, *map(Path, self.cast[:1])]
        missing = [number for number in range(1, self.count + 1) if not is_newer(self.frame(number), *sources)]
        for _, fault in beside_each_other(f"{self.name}, frames", self.draw_frame, missing):
            if fault:
                fail(fault)
        for file in self.frames.glob("[0-9]*.png"):  # of an earlier run with more of them
            if int(file.stem) > self.count:
                file.unlink()
        return missing != []

    def copy_steps(self):
        """The frames at which a lecturer stops, numbered by themselves."""
        steps = self.home / f"steps{self.suffix}"
        shutil.rmtree(steps, ignore_errors=True)
        steps.mkdir()
        for number, stop in enumerate((stop for stop in self.stops if 1 <= stop <= self.count), 1):
            shutil.copyfile(self.frame(stop), steps / f"{number:02}.png")

    def make_video(self, format):
        encoder, resting, turning, settings, turning_settings = FORMATS[format]
        video, new = self.home / f"{self.name}.{format}", self.home / f".new{self.suffix}.{format}"
        status, said = run(["ffmpeg", "-nostdin", "-v", "error", "-y", "-reinit_filter", "0", "-framerate", str(self.rate),
                            "-i", f"{self.frames}/%04d.png", "-filter_complex", turning if self.cast else resting,
                            "-an", "-c:v", encoder, "-threads", "1", "-map_metadata", "-1", "-fflags", "+bitexact",
                            "-flags:v", "+bitexact", *settings.split(), *(turning_settings.split() if self.cast else []),
                            "-f", format, str(new)])
        if status != 0 or not new.exists():
            new.unlink(missing_ok=True)
            return f"{in_words(said)}{video}: ffmpeg could not make it"
        new.replace(video)
        if video.stat().st_size > MOST_BYTES:
            print(f"{video}: {video.stat().st_size / 1e6:.1f} MB is more than {MOST_BYTES / 1e6:.0f}; fewer frames or "
                  "colors make it smaller", file=sys.stderr)
        return ""

    def make(self, formats):
        """A video is made again if a frame is newer, or this program is."""
        drawn_now = self.draw_frames()
        if self.stops:
            self.copy_steps()
        sources = [Path(__file__), *map(self.frame, range(1, self.count + 1))]
        missing = [format for format in formats
                   if FORMATS[format][0] and not is_newer(self.home / f"{self.name}.{format}", *sources)]
        for _, fault in beside_each_other(f"{self.name}, videos", self.make_video, missing):
            if fault:
                fail(fault)
        print(f"  {self.name}: {self.count} frames, {self.count / self.rate:.0f} s"
              f"{'' if drawn_now else ' (all were there)'}", flush=True)


def turns():
    """FRAMES: of a turntable."""
    text = os.environ.get("FRAMES") or str(TURNS)
    if not text.isdecimal() or not 2 <= int(text) <= 9999:
        fail(f"FRAMES={text}: expected a number from 2 to 9999", 2)
    return int(text)


def check_formats(formats):
    for format in formats:
        encoder = FORMATS[format][0]
        if encoder is None:
            continue
        if not shutil.which("ffmpeg"):
            lacks = "ffmpeg is missing, so no video can be made"
        elif f" {encoder} " not in in_words(run(["ffmpeg", "-hide_banner", "-encoders"])[1]):
            lacks = f"ffmpeg has no {encoder} here, so no {format} can be made"
        else:
            continue
        fail(f"{lacks}: 'make setup FOR=lecturer' installs it.\nFORMAT=png makes the numbered pictures alone.", 3)


def main():
    folder, *names = sys.argv[1:]
    folder = Path(folder)
    formats, themes = wanted("FORMAT", "mp4,webm,gif", FORMATS), wanted("THEME", "light,dark", ("light", "dark"))
    folder.mkdir(exist_ok=True)
    end_with_programs()
    os.environ["LC_ALL"] = "C.UTF-8"
    turntable = names[:1] == ["--turn"]
    if not turntable and not shutil.which("gnuplot"):
        fail("gnuplot is missing, so no frame is drawn: 'make setup' installs it.", 3)
    check_formats(formats)
    if turntable:
        _, name, scene, *program = names
        (folder / name).mkdir(exist_ok=True)
        Animation(folder, name, "light", Path(scene), program).make(formats)
    else:
        for name in names:
            for theme in themes:
                Animation(folder, name, theme).make(formats)


main()
