// ioctl.h - the width of a terminal: there is none, and the environment says how wide a line is.
#ifndef CHAPTERS_BOOK_INSTEAD_IOCTL_H
#define CHAPTERS_BOOK_INSTEAD_IOCTL_H

struct winsize {
    unsigned short ws_row, ws_col, ws_xpixel, ws_ypixel;
};
enum { TIOCGWINSZ };

static inline int ioctl(int file, int request, void *into)
{
    (void)file;
    (void)request;
    (void)into;
    return -1;
}

#endif
