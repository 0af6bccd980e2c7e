// forms.h - one camera in the other forms of the slide 'Other camera representations'.
#ifndef CHAPTERS_02_CAMERAS_FORMS_H
#define CHAPTERS_02_CAMERAS_FORMS_H

#include "common/camera.h"

typedef struct {
    LookAt look_at;
    Corners points, vectors;
    vec3 across, upward; // from the lower left corner
} Forms;

// The other forms of this camera, computed with the vectors of exercise 01.
Forms forms_of(Camera camera);

// The handedness of its frame.
Handedness handedness_of(Camera camera);

#endif
