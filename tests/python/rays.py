# SPDX-License-Identifier: AGPL-3.0-or-later
"""Cameras and light fields against closed forms, and against what the renderer drew."""
import pickle
import signal

import numpy as np

import integral
from cases import WALL, colour_of_wall, near, raises, run, same

FRAMES = ("whole", "broken", "round", "squares", "lying")


def rays_of(name, space="sheet"):
    frame = integral.read(name + ".png")
    camera = frame.camera(space)
    return frame, camera, camera.rays(camera.pixel_centres())


def test_rays_meet_the_wall_where_the_renderer_saw_it():
    for name in FRAMES:
        frame, _, rays = rays_of(name)
        o, d = rays.origins, rays.directions
        hit = o + ((WALL - o[:, 2]) / d[:, 2])[:, None] * d
        seen = frame.linear().reshape(-1, 3)
        assert rays.imaged.mean() > 0.6, (name, rays.imaged.mean())
        near(seen[rays.imaged, :2], colour_of_wall(hit[:, 0], hit[:, 1])[rays.imaged], 1e-4)
        same(seen[~rays.imaged], np.zeros_like(seen[~rays.imaged]))


def test_a_scene_seen_with_parallax_has_its_own_rays():
    frame, camera, rays = rays_of("nearer", "scene")
    o, d = rays.origins, rays.directions
    near(o[rays.imaged, 2], -300, 1e-9)  # the scene's eye; the viewer's is 250 mm away
    hit = o + ((WALL - o[:, 2]) / d[:, 2])[:, None] * d
    near(frame.linear().reshape(-1, 3)[rays.imaged, :2],
         colour_of_wall(hit[:, 0], hit[:, 1])[rays.imaged], 1e-4)
    pixels, lenses = camera.pixels_seen(o[rays.imaged], 3 * d[rays.imaged])
    near(pixels, camera.pixel_centres()[rays.imaged], 1e-8)
    same(lenses, rays.lenses[rays.imaged])


def test_a_square_lens_refracts_at_its_pole():
    # Section 3 of doc/optics.md, once more.
    p, t, n, distance, pitch = 1.0, 2.0, 1.5, 300.0, 0.1
    camera = integral.Camera(integral.LensSheet("square", p, t, n),
                             integral.Film((pitch, pitch), 100, 60), integral.Aperture(distance))
    rng = np.random.default_rng(1)
    pixels = rng.uniform((0, 0), (100, 60), (20000, 2))
    rays = camera.rays(pixels)
    assert 0.9 < rays.imaged.mean() < 1
    pixels, rays = pixels[rays.imaged], integral.Rays(*(part[rays.imaged] for part in rays))
    poles = camera.poles(rays.lenses)
    near(poles, p * rays.lenses, 0)
    film = (pixels - (50, 30)) * (pitch, -pitch)
    lateral = n * (poles - film) / np.sqrt(((poles - film) ** 2).sum(1) + t * t)[:, None]
    into = np.column_stack([-lateral, np.sqrt(1 - (lateral ** 2).sum(1))])
    near(rays.directions, into, 1e-15)
    on_aperture = poles + lateral * distance / into[:, 2:]
    near(rays.origins[:, :2], on_aperture, 1e-10)
    near(rays.origins[:, 2], -distance, 0)


def test_pixels_and_rays_are_inverse():
    for name in FRAMES:
        _, camera, rays = rays_of(name)
        centres = camera.pixel_centres()[rays.imaged]
        o, d, lenses = rays.origins[rays.imaged], rays.directions[rays.imaged], rays.lenses[rays.imaged]
        pixels, through = camera.pixels_seen(o + 7 * d, -2 * d)
        near(pixels, centres, 1e-8)
        same(through, lenses)
        for depth in (-40, 55):
            points = o + ((depth - o[:, 2]) / d[:, 2])[:, None] * d
            near(camera.pixels_imaging(points, lenses), centres, 1e-7)


def test_arrays_of_any_strides_and_types():
    _, camera, rays = rays_of("squares")
    centres = camera.pixel_centres()
    for pixels in (np.asfortranarray(centres), centres[::-1][::-1], centres.tolist(),
                   np.repeat(centres, 2, axis=1)[:, ::2]):
        for got, expected in zip(camera.rays(pixels), rays):
            assert np.array_equal(got, expected, equal_nan=got.dtype == float)
    whole = camera.rays(np.array([[3, 4]]))
    same(whole.lenses, camera.rays([[3.0, 4.0]]).lenses)
    same(camera.rays(centres, threads=1).lenses, rays.lenses)


def test_cameras_pickle_and_refuse():
    _, camera, rays = rays_of("round")
    again = pickle.loads(pickle.dumps(camera))
    same(again.rays(again.pixel_centres()).lenses, rays.lenses)
    raises(ValueError, "pixels: an array of shape (n, 2) is expected", camera.rays, [[1, 2, 3]])
    raises(ValueError, "differ in number", camera.pixels_seen, [[0, 0, 1]], [[0, 0, 1], [0, 1, 1]])
    raises(ValueError, "sheet.arrangement must be lenticular, square or hexagonal", integral.Camera,
           integral.LensSheet("cubic"), integral.Film.of_dpi(300, 10, 10), integral.Aperture(300))
    raises(ValueError, "the film has no width and height; give the frame's pixels", integral.Camera,
           integral.LensSheet(), integral.Film.of_dpi(300), integral.Aperture(300))
    raises(ValueError, "threads -3: a number from 0 to 1024", camera.rays, [[1, 2]], -3)
    places, _ = camera.pixels_seen([[0, 0, -300]], [[1, 0, 0]])
    assert np.isnan(places).all()


def test_documents_are_copies():
    frame, camera, _ = rays_of("squares")
    expected, field = frame.lightfield().imaged, frame.lightfield()
    camera.document["film"]["width"] = 7
    assert camera.document["film"]["width"] == 120
    frame.metadata["aperture"]["distance_mm"] = 20
    same(field.imaged, expected)


def test_signals_reach_python_during_many_rays():
    _, camera, rays = rays_of("round")
    signals = []
    signal.signal(signal.SIGALRM, lambda *_: signals.append(1))
    signal.setitimer(signal.ITIMER_REAL, 0.02, 0.02)
    pixels = camera.pixel_centres()
    most = 0  # signals in one call: one after it, without those during it
    while most < 4 and len(pixels) < 10_000_000:
        pixels = np.concatenate([pixels, pixels])
        signals.clear()
        found = camera.rays(pixels, threads=1)
        most = max(most, len(signals))
    signal.setitimer(signal.ITIMER_REAL, 0)
    assert most >= 4, (most, len(pixels))
    same(found.lenses[-len(rays.lenses):], rays.lenses)


def light_field(name):
    frame = integral.read(name + ".png")
    return frame, frame.lightfield()


def test_a_light_field_has_the_colour_that_its_rays_meet():
    for name in FRAMES:
        frame, field = light_field(name)
        distance = frame.aperture.distance_mm
        # From (pole + aperture, -distance) through (pole, 0) to the wall.
        across = field.aperture_mm[:, :, None, None]
        place = field.poles_mm[None, None] - across * WALL / distance
        linear = integral.Frame(field.samples.reshape(-1, field.samples.shape[3], 3)).linear()
        linear = linear.reshape(field.samples.shape)[..., :2]
        expected = colour_of_wall(place[..., 0], place[..., 1])
        inner = field.imaged
        assert inner.mean() > 0.3, (name, inner.mean())
        channels = {"whole": [0], "lying": [1]}.get(name, [0, 1])  # across cylinders
        near(linear[inner][:, channels], expected[inner][:, channels], 3e-4)


def test_a_light_field_of_whole_pixels_is_a_view():
    for name, shape in (("whole", (1, 15, 90, 9, 3)), ("squares", (10, 10, 9, 11, 3)),
                        ("lying", (15, 1, 9, 90, 3))):
        frame, field = light_field(name)
        assert field.is_view and np.shares_memory(field.samples, frame.image)
        assert field.samples.shape == shape, field.samples.shape
        # A sample is the pixel of its direction below its lens.
        camera = frame.camera()
        v, u, t, s = (n // 2 for n in shape[:4])
        field.samples[v, u, t, s] = 12345
        row, column = np.argwhere((frame.image == 12345).all(axis=2))[0]
        start = camera.rays([[column + 0.5, row + 0.5]]).origins[0, :2]
        across = {"whole": [0], "lying": [1]}.get(name, [0, 1])
        near(start[across], (field.poles_mm[t, s] + field.aperture_mm[v, u])[across], 1e-6)


def test_axes_of_a_light_field():
    frame, field = light_field("squares")
    near(field.s_mm, np.arange(-5, 6), 1e-12)
    assert (np.diff(field.t_mm) < 0).all() and (np.diff(field.s_mm) > 0).all()
    assert (np.diff(field.u_mm) < 0).all() and (np.diff(field.v_mm) > 0).all()
    near(field.u_mm, field.aperture_mm[5, :, 0], 1e-12)
    near(field.v_mm, field.aperture_mm[:, 5, 1], 1e-12)
    near(field.poles_mm[2, :, 0], field.s_mm, 1e-12)
    coarse = frame.lightfield((4, 3))
    assert coarse.samples.shape[:2] == (3, 4) and not coarse.is_view
    for number in (0, 20000):
        raises(ValueError, f"number of directions {number}: a number from 1 to 4096",
               frame.lightfield, (number, 3))
    raises(ValueError, "too many samples; choose fewer directions, at most 4096 one way",
           integral.Frame(np.zeros((300, 4, 3), np.uint8), integral.LensSheet("square", 0.2, 2, 1.5),
                          integral.Film((0.1, 0.1)), frame.aperture).lightfield, (4096, 4096))


def test_hexagonal_rows_are_shifted_by_half_a_pitch():
    _, field = light_field("round")
    shift = field.poles_mm[1:, 0, 0] - field.poles_mm[:-1, 0, 0]
    near(np.abs(shift), 0.5, 1e-12)
    near(-np.diff(field.t_mm), np.sqrt(0.75), 1e-12)


run(globals())
