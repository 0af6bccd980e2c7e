// finish_figure.js - makes of gnuplot's SVG the figure that a page shows: as 'make figures' does
// (chapters/gallery/draw_figures.py), and with the pictures in it, which gnuplot cannot read in a page.

const escaped = text => text.replace(/&/g, '&amp;').replace(/</g, '&lt;').replace(/>/g, '&gt;');

/** The rectangle around a frame, from "d='M12.48,456.30 L473.28,456.30 ..."; undefined if there is none. */
function frameIn(line) {
  const corners = [.../d='M([^']*)/.exec(line)?.[1].matchAll(/([\d.-]+),([\d.-]+)/g) ?? []];
  const [[left, right], [top, bottom]] = [1, 2].map(i => corners.map(corner => Number(corner[i])))
    .map(numbers => [Math.min(...numbers), Math.max(...numbers)]);
  return left < right && top < bottom ? {left, top, width: right - left, height: bottom - top} : undefined;
}

/** The PNG of a picture in base64, as the script has it: '$flat << EOD' and so on; undefined if it has not. */
function pictureIn(script, name) {
  const rows = script.split(`\n${name} << EOD\n`)[1]?.split('\nEOD')[0];
  return rows?.split('\n').filter(row => !row.startsWith('#')).join('');
}

/**
 * @param {string} svg by gnuplot
 * @param {string} words the figure in words: its title, and its description
 * @param {string} script with the pictures for which gnuplot drew frames (common/figure/pictures.gp)
 */
export function finishFigure(svg, words, script) {
  const [title, ...rest] = words.replace(/ +/g, ' ').replace(/ \n/g, '\n').split('\n');
  let titled = false, described = false, picture;
  const lines = svg.replace(/\n$/, '').split('\n').map(line => {
    if (!titled && line.includes('<title>')) {
      titled = true;
      return `<title id="title">${escaped(title)}</title>`;
    }
    if (!described && line.includes('<desc>')) {
      described = true;
      return `<desc id="description">${escaped(rest.join(' ').trim())}</desc>`;
    }
    const framed = /<title>picture ([^:]*): */.exec(line);
    if (framed) {
      picture = pictureIn(script, framed[1]);
      return line.replace(framed[0], '<title>');
    }
    const frame = picture && frameIn(line);
    if (frame) {
      const [x, y, width, height] = [frame.left, frame.top, frame.width, frame.height].map(n => n.toFixed(2));
      const image = `<image x='${x}' y='${y}' width='${width}' height='${height}' preserveAspectRatio='none' ` +
        `xlink:href='data:image/png;base64,${picture}'/>`;
      picture = undefined;
      return image;
    }
    return line.replace(/^<svg/, '<svg role="img" aria-labelledby="title description" xml:space="preserve"')
      .replace(/(id=.gpPt.*?stroke-width=')[\d.]+/, (_, before) => `${before}0.6`);
  });
  return lines.join('\n').replaceAll('font-family="DejaVu Sans"', 'font-family="DejaVu Sans, Verdana, sans-serif"')
    .replaceAll('font-family="DejaVu Serif"', 'font-family="DejaVu Serif, Georgia, serif"') + '\n';
}
