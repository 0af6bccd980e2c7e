// cast.h - the command line of chapter 08: which engine draws which scene.
#ifndef CHAPTERS_08_FAST_ENGINES_CAST_H
#define CHAPTERS_08_FAST_ENGINES_CAST_H

// Does what the command line says. Returns the result of main.
int cast_command(int argc, char **argv);

#endif
