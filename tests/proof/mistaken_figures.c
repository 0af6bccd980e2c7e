// mistaken_figures.c - the program of a chapter with a known mistake in the place of a right
// answer. Linked with that program.
//
//   mistaken_figures list                  of each: stem, exercise, id, formula, why, picture
//   mistaken_figures NUMBER ARGUMENT...    the program, by that one of the list; -1: by none
#include "tests/judge/known.h"
#include "tests/judge/message.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// The program's own main: this one is called in its place (-Wl,--wrap=main).
int __real_main(int argc, char **argv);
int __wrap_main(int argc, char **argv);

int __wrap_main(int argc, char **argv)
{
    bool lists = argc == 2 && strcmp(argv[1], "list") == 0;
    int left = argc > 1 ? atoi(argv[1]) : 0;
    for (int i = 0; left >= 0 && exercises[i].name != NULL; i++) {
        if (i > 0 && strcmp(exercises[i].stem, exercises[i - 1].stem) == 0)
            continue;
        choose_stem(exercises[i].stem);
        for (const Mistake *it = known_answers(WRONG_ANSWERS); it != NULL; it = it->next) {
            if (lists) {
                printf("%s\t%s\t%s\t%s\t%s\t%s\n", exercises[i].stem, it->exercise, it->id,
                       it->formula, it->why, it->picture);
            } else if (left-- == 0) {
                answer_by(exercise_number(it->exercise), it->answer);
                break;
            }
        }
    }
    if (lists)
        return 0;
    argv[1] = argv[0];
    return __real_main(argc - 1, argv + 1);
}
