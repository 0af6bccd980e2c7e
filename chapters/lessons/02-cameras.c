// 02-cameras.c - the numbers of lesson 02.
#include "chapters/02-cameras/forms.h"
#include "chapters/lessons/fill.h"
#include "chapters/shared/example.h"
#include "common/text.h"

static const char *const handedness_names[] = {
    [RIGHT_HANDED] = "right-handed", [LEFT_HANDED] = "left-handed"};

static void fill_handedness(Camera c)
{
    Handedness hand = handedness_of(c);
    fill_vector("right_x_up", vec3_cross(c.right, c.up));
    fill_text("same_as", "%s", hand == LEFT_HANDED ? "f" : "-f");
    fill_text("handedness", "%s", handedness_names[hand]);
    fill_text("other_handedness", "%s",
              handedness_names[hand == LEFT_HANDED ? RIGHT_HANDED : LEFT_HANDED]);
    fill_vector("minus_right", -c.right);
}

void fill_numbers(void)
{
    Camera c = example_camera();
    Forms forms = forms_of(c);
    fill_camera(c);
    fill_handedness(c);
    fill_vector("at", forms.look_at.at);
    fill_number("aspect", forms.look_at.aspect);
    fill_vector("point_upper_left", forms.points.upper_left);
    fill_vector("point_upper_right", forms.points.upper_right);
    fill_vector("point_lower_left", forms.points.lower_left);
    fill_vector("point_lower_right", forms.points.lower_right);
    fill_vector("across", forms.across);
    fill_vector("upward", forms.upward);
    fill_vector("upper_left", forms.vectors.upper_left);
    fill_vector("upper_right", forms.vectors.upper_right);
    fill_vector("lower_left", forms.vectors.lower_left);
    fill_vector("lower_right", forms.vectors.lower_right);
    fill_vector("mean", forms.look_at.at - c.origin);
    fill_number("degrees", 2 * atan(c.width / 2 / c.distance) * 180 / PI);
    fill_option("eye_option", forms.look_at.eye);
    fill_option("at_option", forms.look_at.at);
    bool square = c.width == c.height;
    fill_text("aspect_option", "%s%s", square ? "" : " --aspect ",
              square ? "" : number_text(forms.look_at.aspect).s);
}
