#!/bin/sh
# explain.sh - what a student reads where an answer does not compile, by any compiler ($CC): the
# common mistakes, functions that nobody declared, types.
# Only reads the tree.
set -u
. tests/house/runner/explained.sh

# ---- the common five, and the missing return ----------------------------------------------------

broken 01-corners 's|c.height / 2 \* c.up;|c.height / 2 * c.up|'
check 'a missing semicolon is reported, with its line' \
    helps "a semicolon is missing at the end of line $(line_of 'c.height / 2 * c.up')."
check 'a missing semicolon: only their own file' only_their_own
check 'help that was given is not repeated' [ "$(grep -c 'help:' "$scratch/said")" -eq 2 ]

broken 02-cameras 's|vec3 ahead = view.at - view.eye;|vec3 ahead = view.at - view.eye // no|'
check 'where the next line is blamed, the line before is named' \
    helps "a semicolon is missing at the end of line $(line_of 'vec3 ahead')."
check 'what only follows from a missing semicolon is left out' says_not 'undeclared'

broken 01-corners 's|return c.distance \* c.forward|return c.distance c.forward|'
check 'a missing operator is not a missing semicolon alone' helps "in line $(line_of 'distance c.f') a semicolon is missing, or an operator"

broken 05-quadratic 's|double a = vec3_dot(v, v);|double a = v * v;|'
check 'v * v as a number: vec3_dot is named' helps 'v * w multiplies component by component and gives a vector; for a number, write vec3_dot(v, w).'
check 'v * v as a number: only their own file' only_their_own
check 'nobody reads how a vec3 is built' says_not '__vector'
broken 05-quadratic 's|double l = fmin.*|double l = sqrt(closest * closest);|'
check 'v * v handed to sqrt: vec3_dot is named' helps 'v * w multiplies'
check 'v * v handed to sqrt: only their own file' only_their_own
broken 05-quadratic 's|if (!(l_squared <= r \* r))|if (closest * closest > r * r)|'
check 'v * v compared with a number: vec3_dot is named' helps 'v * w multiplies'
broken 02-cameras 's|return 2 \* distance \* tan.*|vec3 v = {1, 2, 3}; return v * v;|'
check 'v * v returned as a number: vec3_dot is named' helps 'v * w multiplies'
broken 02-cameras 's|double distance = vec3_length(ahead)|double distance = ahead|'
check 'a vector for a number, without a product: the help says how to make one' \
    helps 'this is a vector, but a number is expected'
broken 05-quadratic 's|vec3_dot(p, p) - radius|vec3_dot(p, radius) - radius|'
check 'a number for a vector gets no such help' says_not 'a vector stands'
check 'but the help says what is expected' \
    helps 'vec3_dot expects a vec3 there, but this is a double. Its prototype is double vec3_dot(vec3 v, vec3 w) in'

broken 05-quadratic 's|double a = vec3_dot(v, v);|double a = v.x * v.x;|'
check 'v.x: the help names v[0]' helps 'a vec3 has no named parts: its components are v[0], v[1], v[2].'

broken 05-quadratic 's|return NO_HIT|return nothing|'
check 'an undeclared name: the help says where to look' \
    helps 'nothing here is called nothing. Is it spelled as in the contract, exercises/05-quadratic.h?'
broken 05-quadratic 's|roots = sphere_roots|roots = spere_roots|'
check 'an undeclared function: the help says where to look' helps 'nothing here is called spere_roots.'
check 'what only follows from an undeclared function is left out' alone
broken 01-corners 's|c.width / 2|width / 2|'
check 'a part without its whole: the help names whose it is' helps 'width is a part of a Camera (common/camera.h)'
broken 02-cameras 's|PI / 180|M_PI / 180|; s|^// Stores.*|#undef M_PI|'
check 'M_PI: the help names PI' helps 'C11 has no M_PI: write PI (common/vec3.h).'
broken 06-ray-casting '/#include "exercises.05/d'
check 'a function of another chapter: the help names its header' \
    helps 'hit_sphere is declared in another file: #include "exercises/05-quadratic.h"'
broken 01-corners 's|return c.distance \* c.forward -|printf("here");\n    &|'
check 'printf: the help names its header' helps 'printf is in the standard library: #include <stdio.h>'

broken 05-quadratic 's|vec3_dot(p, p) - radius|vec3_dot(p) - radius|'
check 'too few arguments: the prototype is shown' \
    helps 'its prototype is double vec3_dot(vec3 v, vec3 w) in common/vec3.h.'
check 'too few arguments: only their own file' only_their_own
broken 05-quadratic 's|vec3_dot(p, p) - radius|vec3_dot(p, p, v) - radius|'
check 'too many arguments: the prototype is shown' helps 'its prototype is double vec3_dot('
broken 06-ray-casting 's|pixel_ray(camera, image->size, pixel)|pixel_ray(camera, pixel)|'
check 'one left out in the middle is too few, not a wrong type' says_not 'incompatible'
check 'one left out in the middle: the prototype is shown' \
    helps 'its prototype is Ray pixel_ray(Camera camera, Resolution screen, Pixel pixel) in exercises/04-pixel-ray.h.'

broken 02-cameras 's|return 2 \* distance \* tan.*|if (distance > 3) return 2;|'
check 'a missing return: the help says why it matters' helps 'the function ends without return'
check 'a missing return is an error, said once' alone
broken 01-corners 's|return c.distance . c.forward + (s|c.distance * c.forward + (s|'
check 'a result that is not returned: the help names the line' \
    says "then undefined. Line $(line_of '    c.distance * c.forward + (s') computes a value, but does not return it."
check 'a result that is not given back: alone' alone
broken 02-cameras 's|return 2 \* distance \* tan.*|return;|'
check 'a return without a value is not a missing return' helps 'return without a value: this function must return one'
broken 01-corners 's|c.width / 2 \* c.right + c.height / 2 \* c.up;|w;|'
check 'but not where the return is what is wrong' says_not 'ends without return'

# ---- functions that nobody declared -------------------------------------------------------------

explains 'dot: the help names vec3_dot' 05-quadratic 's|vec3_dot(p, p) - radius|dot(p, p) - radius|' \
    'here its name is vec3_dot: double vec3_dot(vec3 v, vec3 w) in common/vec3.h.'
explains 'cross: the help names vec3_cross' 02-cameras \
    's|vec3_cross(forward, view.up)|cross(forward, view.up)|' 'here its name is vec3_cross:'
explains 'normalize: the help names vec3_unit' 02-cameras \
    's|vec3_unit(sideways)|\n        normalize(sideways)|' \
    'here its name is vec3_unit: vec3 vec3_unit(vec3 v)'
explains 'unit: the help names vec3_unit' 02-cameras 's|vec3_unit(sideways)|unit(sideways)|' \
    'here its name is vec3_unit:'
for name in length norm magnitude; do
    explains "$name: the help names vec3_length" 05-quadratic \
        "s|distance = vec3_length(p)|distance = $name(p)|" \
        'here its name is vec3_length: double vec3_length(vec3 v)'
done
explains 'print: the help names printf' 05-quadratic \
    's|    return NO_HIT|    print("x"); return NO_HIT|' 'in C its name is printf, of <stdio.h>.'
explains 'the name the compiler thinks of: the help names its header' 02-cameras \
    's|vec3_cross(f|vec3_cros(f|' \
    'nothing here is called vec3_cros. vec3_cross is in common/vec3.h.'
check 'the compiler may say what it thinks of' says "did you mean 'vec3_cross'?"

# ---- types --------------------------------------------------------------------------------------

explains 'a vector for a struct: the help names the struct' 04-pixel-ray \
    's|return (Ray).*|return image_plane_vector(camera, place.s, place.t);|' \
    'pixel_ray returns a Ray (exercises/04-pixel-ray.h), but this is a vec3. Write (Ray){origin, direction}.'
check 'a vector for a struct is not a vector for a number' says_not 'number is expected'
explains 'a struct for a vector: the help names the vector' 01-corners \
    's|return image_plane_vector.*|return c;|' \
    'across_30_up_10 returns a vec3 (exercises/01-corners.h), but this is a Camera. Write vec3_of(x, y, z).'
explains 'a struct for a number: the help names its parts' 05-quadratic 's|return NO_HIT|return roots|' \
    'hit_sphere returns a double (exercises/05-quadratic.h), but this is a Roots. Its parts are count, t.'
broken 05-quadratic 's|Roots roots = sphere_roots(ray|double roots = sphere_roots(ray|'
check 'a variable of the wrong type is suspected' helps 'a double is expected here, but this is a Roots. Is the type of the variable right?'
explains 'the wrong argument: the help names the function that makes a right one' 04-pixel-ray \
    's|pixel_center(pixel)|pixel|' \
    'screen_to_normalized expects a ScreenPoint there, but this is a Pixel. pixel_center (exercises/03-screen.h) makes a ScreenPoint of a Pixel.'
explains 'the wrong initializer: the help names the function that makes a right one' 04-pixel-ray \
    's|Normalized place = .*|Normalized place = pixel_center(pixel);|' \
    'a Normalized is expected here, but this is a ScreenPoint. screen_to_normalized (exercises/03-screen.h) makes a Normalized of a ScreenPoint and a Resolution.'
broken 06-ray-casting 's|pixel_ray(camera, image->size, pixel)|pixel_ray(camera, pixel, image->size)|'
check 'arguments exchanged: the prototype is shown' \
    helps 'pixel_ray expects a Resolution there, but this is a Pixel: the arguments are in another order. Its prototype is Ray pixel_ray(Camera camera, Resolution screen, Pixel pixel)'
check 'arguments exchanged: said once for each call' [ "$(grep -c "^$answer:" "$scratch/said")" -eq 2 ]

explains 'a number has no parts' 01-corners 's|c.distance \* c.forward -|c.distance.forward -|' \
    'c.distance is a number and has no parts. forward is a part of a Camera.'
explains 'a part a Pixel does not have' 03-screen 's|pixel.row|pixel.y|' \
    'the parts of a Pixel are column, row (common/screen.h).'
explains 'a part a Normalized does not have' 04-pixel-ray 's|place.s|place.x|' \
    'the parts of a Normalized are s, t (common/screen.h).'
explains 'a part a Sphere does not have' 05-quadratic 's|sphere.center, ray|sphere.position, ray|' \
    'the parts of a Sphere are center, radius, surface (common/sphere.h).'
explains 'a part a ScreenPoint does not have' 03-screen 's|point.y /|point.row /|' \
    'the parts of a ScreenPoint are x, y (common/screen.h).'
explains 'a part a Roots does not have' 05-quadratic 's|(roots.t.i. > 0)|(roots.t1 > 0)|' \
    'the parts of a Roots are count, t (exercises/05-quadratic.h).'
explains 'a part a Ray does not have, where it is made' 04-pixel-ray \
    's|return (Ray).*|return (Ray){.eye = camera.origin};|' \
    'the parts of a Ray are origin, direction (common/ray.h).'
broken 01-corners 's|c.width / 2|c.w / 2|'
check 'a part a Camera does not have' \
    helps 'the parts of a Camera are origin, right, up, forward, distance, width, height (common/camera.h).'

explains '-> on a value' 01-corners 's|c.distance \* c.forward -|c->distance * c->forward -|' \
    'c is not a pointer: write c.distance.'
explains '. on a pointer' 02-cameras 's| \*camera = found| camera.origin = found.origin|' \
    'camera is a pointer: write camera->origin.'
explains '-> to a part that is not there' 06-ray-casting \
    's|image_set(image, pixel, scene_surface(scene, sphere)->|image_set(image, pixel, scene->spheres[sphere]->|' \
    'scene->spheres[sphere] is a Sphere, whose parts are center, radius, surface. For its look, write scene_surface(scene, i)->color.'
broken 06-ray-casting 's|image_set(image, pixel,|image_set(*image, pixel,|'
check 'a * too many' helps 'image_set expects an Image * there, but this is an Image. Remove the *: without it, this is a pointer.'
check 'a * too many is no & too few' says_not 'A & in front'

explains 'a . for a part that is not there' 06-ray-casting '/^void cast_image/,/^}/s|image->size.height|image.height|' \
    'image points to an Image, whose parts are size, rgb, progress, set_count.'
broken 06-ray-casting 's|hit_sphere(ray, scene->spheres.i.)|hit_sphere(ray, scene->spheres)|'
check 'all of them for one of them' helps 'hit_sphere expects a Sphere there, but this is a Sphere *. One of them is scene->spheres[i].'
broken 02-cameras '/^CameraFault camera_from_vec/,/^}/s|return give(found, camera)|camera = found; return CAMERA_OK|'
check 'a pointer for what it points to' helps 'a Camera * is expected here, but this is a Camera. To store it where camera points, write *camera = ...'
explains 'a camera for a fault' 02-cameras '/^CameraFault camera_from_look/,/^}/s|return give(found, camera)|return found|' \
    'camera_from_look_at returns a CameraFault (exercises/02-cameras.h), but this is a Camera. A CameraFault is one of CAMERA_OK, CAMERA_NOT_FINITE, CAMERA_NOT_UNIT, ... (common/camera.h).'
explains 'a number for a sphere' 07-shading '/^Color shade/,/^}/s|Sphere sphere = scene->spheres.hit.sphere.|Sphere sphere = hit.sphere|' \
    'a Sphere is expected here, but this is an int. Is the type of the variable right?'
explains 'a vector in arithmetic with a struct' 05-quadratic 's|(Ray){ray.origin - sphere.center|(Ray){ray.origin - sphere|' \
    'there is no arithmetic with a Sphere as a whole: its parts are center, radius, surface.'
explains 'a struct with a number in brackets' 03-screen 's|pixel.column + 0.5|pixel[0] + 0.5|' \
    'a Pixel has no numbered parts: they are called column, row.'
explains 'a call for an element' 05-quadratic '/^double hit_sphere/,/^}/s|if (roots.t.i.|if (roots.t(i)|' \
    'roots.t(...) is a call of a function; an element of an array is roots.t[...].'
explains 'a * on a number' 06-ray-casting 's|depth.i. = t;|*depth[i] = t;|' \
    'a * in front of a name reads through a pointer, and this is not a pointer: remove the *.'

# ---- the deck's letters -------------------------------------------------------------------------

explains "the slide's own line" 01-corners \
    '/^vec3 upper_left/,/^}/s|return .*|return d * f - w / 2 * r + h / 2 * u;|' \
    "the slide's d is c.distance, f is c.forward, w is c.width, r is c.right, h is c.height, u is c.up."
explains 'by the names of this function' 04-pixel-ray 's|return (Ray){camera.origin|return (Ray){p|' \
    "the slide's p is camera.origin."
explains 'p, v, c and r of a ray and a sphere' 05-quadratic \
    's|vec3 p = ray.origin, v = ray.direction, c = sphere.center;||; s|sphere.radius . sphere.radius};|r * r};|' \
    "the slide's v is ray.direction, p is ray.origin, c is sphere.center, r is sphere.radius."
explains 'r that is a number' 05-quadratic 's|radius \* radius}|r * r}|' "the slide's r is radius."
explains 'd of an angle' 02-cameras 's|return 2 . distance|return 2 * d|' "the slide's d is distance."
explains 'W and H of the screen' 03-screen '/^Normalized/,/^}/s|point.x / screen.width, 1 - point.y / screen.height|point.x / W, 1 - point.y / H|' \
    "the slide's W is screen.width, H is screen.height."
broken 02-cameras '/^CameraFault camera_from_look_at/,/^}/s|double distance = .*|double distance = d;|'
check 'a camera that is still to be made has no parts yet' says_not 'camera->distance'
explains 'as parts of a camera' 01-corners '/^vec3 upper_left/,/^}/s|return .*|return c.d * c.f - c.w / 2 * c.r;|' \
    "the parts of a Camera are origin, right, up, forward, distance, width, height (common/camera.h). The slide's d is c.distance, f is c.forward, w is c.width, r is c.right."
explains 'a, b and c together are the quadratic' 05-quadratic '/^Quadratic object/,/^}/s|return .*|return (Quadratic){a, b, c};|' \
    'nothing here is called a, b, c. The parameters of object_quadratic are Ray object_ray and double radius.'
explains 'the camera of another function' 01-corners 's|return image_plane_vec.*|return camera.distance * c.forward;|' \
    'nothing here is called camera. The Camera has another name here: write c.distance.'
explains 'a height of two things' 06-ray-casting '/^void cast_image/,/^}/s|image->size.height|height|' \
    'height is the name of parts: write camera.height or image->size.height.'
explains 'a part that has the name of a function' 02-cameras 's|vec3 across = vectors.upper_right|vec3 across = upper_right|' \
    'upper_right is a part of a Corners (common/camera.h): write vectors.upper_right.'
explains 'capitals' 05-quadratic '/^double hit_sphere/,/^}/s|NO_HIT|no_hit|' \
    'nothing here is called no_hit. It is written NO_HIT (common/ray.h).'
explains 'a variable is not a type' 06-ray-casting '/^void cast_image/,/^}/s|nearest_hit(pixel_ray(camera, image->size, pixel), scene)|nearest_hit(ray, scene)|' \
    'nothing here is called ray. A Ray of your own must be declared first: Ray ray = ...;'
explains 'a loop that declares nothing' 05-quadratic '/^double hit_sphere/,/^}/s|for (int i|for (i|' \
    'i is not declared: for (int i = ...; ...; ...).'
explains 'letters that nobody has' 01-corners 's|return image_plane_vec.*|return c.forward + (s - t) * a * c.up;|' \
    'nothing here is called s, t, a. The parameter of across_30_up_10 is Camera c. Declare a variable of your own first, with its type.'
broken 01-corners 's|return image_plane_vec.*|return c.forward + (s - t) * a * c.up;|'
check 'no types of other chapters' says_not 'Normalized'
explains 'what this function is given' 02-cameras 's|tan(degrees|tan(angle|' \
    'nothing here is called angle. Is it spelled as in the contract, exercises/02-cameras.h? The parameters of width_from_angle are double degrees and double distance.'

# ---- the first line of a function, and the order of arguments -------------------------------------

explains 'a signature that is not the contract' 01-corners '/^vec3 upper_left/s|Camera c|Camera *c|' \
    'the contract, exercises/01-corners.h, says vec3 upper_left(Camera c): your function must begin like that.'
explains 'a parameter that was taken away' 01-corners 's|Camera c, double s, double t|Camera c, double s|' \
    'the contract, exercises/01-corners.h, says vec3 image_plane_vector(Camera c, double s, double t):'
explains 'another type of result' 05-quadratic 's|^double hit_sphere|int hit_sphere|' \
    'the contract, exercises/05-quadratic.h, says double hit_sphere(Ray ray, Sphere sphere):'
explains 'an answer that is static' 05-quadratic 's|^double hit_sphere|static &|' \
    'remove the static in front of hit_sphere'
explains 'a function that there is already' 05-quadratic 's|^double hit_sphere|double vec3_dot(vec3 a, vec3 b) { return a[0] * b[0]; }\n&|' \
    'vec3_dot is already in common/vec3.h: use it, or give yours another name.'
broken 01-corners 's|^vec3 upper_right(|vec3 upper_left(|'
check 'a function that was copied' helps "upper_left is already defined in line $(line_of 'vec3 upper_left')."
broken 04-pixel-ray 's|(pixel_center(pixel), screen)|(screen, pixel_center(pixel))|'
check 'exchanged arguments are known as such' \
    helps 'screen_to_normalized expects a ScreenPoint there, but this is a Resolution: the arguments are in another order. Its prototype is Normalized screen_to_normalized(ScreenPoint point, Resolution screen)'
broken 01-corners 's|image_plane_vector(c, 0.3, 0.1)|image_plane_vector(0.3, 0.1, c)|'
check 'numbers first as well' helps 'image_plane_vector expects a Camera there, but this is a double: the arguments are in another order.'
broken 06-ray-casting 's|pixel_ray(camera, image->size, pixel)|pixel_ray(image->size, pixel, camera)|'
check 'and all of them' helps 'pixel_ray expects a Camera there, but this is a Resolution: the arguments are in another order.'

finish explain
