// command_words.c - the words of a command, one after the other.
#include "tests/course/programs.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void command_add(Command *command, const char *word)
{
    if (command->count == MOST_WORDS) {
        fprintf(stderr, "a command of more than %d words\n", MOST_WORDS);
        exit(2);
    }
    command->words[command->count++] = word;
    command->words[command->count] = NULL;
}

void command_words(Command *command, const char *text)
{
    char *copy = strdup(text);
    if (copy == NULL || command->part_count == MOST_WORDS)
        abort();
    command->parts[command->part_count++] = copy;
    for (char *rest = copy, *word; (word = strtok_r(rest, " ", &rest)) != NULL;)
        command_add(command, word);
}

void command_words_for(Command *command, const char *text, const char *name)
{
    char *words = NULL;
    size_t size;
    FILE *out = open_memstream(&words, &size);
    if (out == NULL)
        abort();
    for (const char *at; (at = strstr(text, "NAME")) != NULL; text = at + strlen("NAME"))
        fprintf(out, "%.*s%s", (int)(at - text), text, name);
    fputs(text, out);
    fclose(out);
    command_words(command, words);
    free(words);
}

void command_free(Command *command)
{
    for (int i = 0; i < command->part_count; i++)
        free(command->parts[i]);
    *command = (Command){.count = 0};
}
