# SPDX-License-Identifier: AGPL-3.0-or-later
# Measures the error of a halftone as eyes see it. Replays a frame, its halftone (a page of the frame's size) and
# Pillow's error diffusion of the frame's linear light (Floyd and Steinberg) for three eyes at the
# viewing distance; takes the differences from the frame in linear light; blurs them as an eye does,
# by a Gaussian with a standard deviation of one minute of arc; and prints the root mean squares.
#
#   halftone_error.py FRAME HALFTONE [--most RATIO] [--ordinary FILE] [--samples N] [--as-seen]
#
# --most: exit status 1 if the halftone's error is more than so much of the ordinary one, or if the
# whole halftone is not as bright as the frame to 1%. --ordinary: keeps the ordinary halftone.
# --as-seen: with the blur of curved lenses and printed dots; else with a pupil of 4 mm alone.
# Environment: INTEGRAL, the integral program.
import argparse, json, os, subprocess, sys, tempfile
import numpy as np
from PIL import Image
from PIL.PngImagePlugin import PngInfo

arguments = argparse.ArgumentParser()
arguments.add_argument('frame')
arguments.add_argument('halftone')
arguments.add_argument('--most', type=float)
arguments.add_argument('--ordinary')
arguments.add_argument('--samples', default='5')
arguments.add_argument('--as-seen', action='store_true')
o = arguments.parse_args()

def light(picture):
    v = np.asarray(picture.convert('RGB'), float) / 255
    return np.where(v <= .04045, v / 12.92, ((v + .055) / 1.055) ** 2.4)

luminance = np.array([[.2126], [.7152], [.0722]])
original, dots = Image.open(o.frame), Image.open(o.halftone)
grey = dots.mode in '1L'
frame_light = light(original)
linear = frame_light @ luminance if grey else frame_light
about = json.loads(original.text['integral'])
distance = about['aperture']['distance_mm']
pixels = np.array([about['film']['width'], about['film']['height']])
pitch = np.array(about['film']['pixel_pitch_mm'])
size = [int(side) for side in np.round(pixels * pitch / pitch.max())] # square pixels

def low_pass(picture, sigma):
    pad = int(4 * sigma) + 1
    picture = np.pad(picture, ((pad, pad), (pad, pad), (0, 0)), mode='reflect')
    fy = np.fft.fftfreq(picture.shape[0])[:, None, None]
    fx = np.fft.fftfreq(picture.shape[1])[None, :, None]
    gain = np.exp(-2 * np.pi ** 2 * sigma ** 2 * (fx ** 2 + fy ** 2))
    blurred = np.fft.ifft2(np.fft.fft2(picture, axes=(0, 1)) * gain, axes=(0, 1)).real
    return blurred[pad:-pad, pad:-pad]

with tempfile.TemporaryDirectory() as folder:
    def seen(path):
        views = []
        for x, y in ((0, 0), (37, -5), (-60, 8)):
            view = os.path.join(folder, 'view.png')
            subprocess.run([os.environ['INTEGRAL'], 'replay', path, '-o', view, '--eye', f'{x},{y},{distance}',
                            '--size', '%dx%d' % tuple(size), '--pupil', '4', '--samples', o.samples,
                            *(['--as-seen'] if o.as_seen else [])], check=True)
            views.append(light(Image.open(view)) @ luminance if grey else light(Image.open(view)))
        return views

    ordinary = o.ordinary or os.path.join(folder, 'ordinary.png')
    diffused = [np.asarray(Image.fromarray(np.uint8(np.round(255 * linear[:, :, c]))).convert('1').convert('L'))
                for c in range(linear.shape[2])]
    metadata = PngInfo()
    metadata.add_itxt('integral', original.text['integral'])
    Image.fromarray(np.squeeze(np.dstack(diffused))).save(ordinary, pnginfo=metadata)

    sigma = np.radians(1 / 60) * distance / pitch.max()
    of_frame = seen(o.frame)
    def error(path): # without the film's edges, which are black outside
        squares = [np.mean(low_pass(a - b, sigma)[16:-16, 32:-32] ** 2) for a, b in zip(of_frame, seen(path))]
        return np.sqrt(np.mean(squares))
    errors = error(ordinary), error(o.halftone)

kept = (light(dots) @ luminance).mean() / (frame_light @ luminance).mean()
ratio = errors[1] / errors[0]
print(f'ordinary {errors[0]:.4f} halftone {errors[1]:.4f} ratio {ratio:.2f} light {kept:.4f}')
sys.exit(o.most is not None and not (ratio <= o.most and abs(kept - 1) < .01))
