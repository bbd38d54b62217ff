# SPDX-License-Identifier: AGPL-3.0-or-later
# Calibrates random hand-made panels by the cards of `integral lcd --card pitch`, as the simulated
# eye of lens_cards_eye.py reads them.
#
#   lens_cards_read.py [--panels N] [--seed N] [--small] [--curved] [--most-pitch P] [--most-slant D]
#                      [--least-share S] [--views FOLDER]
#
# Descriptions are wrong by up to 1% and 1.5 degrees. Prints a line for each panel and percentiles
# of the errors that are left. Exit status 1 if less than the share S of the panels is within both
# bounds (pitch relative, slant in degrees); a refused reading is an infinite error. --small: panels
# of two million pixels alone. --curved: lenses are cylinders, with the aberrations of these.
# --views: writes the first panel's cards and what the eye sees of them. Environment: INTEGRAL.
import argparse, json, os, subprocess, sys, tempfile
import numpy as np
from PIL import Image
from lens_cards_eye import card_light, reading, write_view

arguments = argparse.ArgumentParser()
arguments.add_argument('--panels', type=int, default=5)
arguments.add_argument('--seed', type=int, default=1)
arguments.add_argument('--most-pitch', type=float, default=2e-4)
arguments.add_argument('--most-slant', type=float, default=.02)
arguments.add_argument('--least-share', type=float, default=.95)
arguments.add_argument('--small', action='store_true')
arguments.add_argument('--curved', action='store_true')
arguments.add_argument('--views')
o = arguments.parse_args()
random = np.random.default_rng(o.seed)

# Pixels across and down, and their width in mm: 24, 16, 27, 27 and 16 inches.
displays = [(1920, 1080, .2745), (1920, 1080, .1794), (2560, 1440, .2331), (3840, 2160, .1554), (3840, 2160, .0900)]

def random_panel():
    width, height, pixel = displays[random.integers(2 if o.small else len(displays))]
    pitch = pixel * random.uniform(3.5, 6.5 if width < 3000 else 9)
    return dict(width=width, height=height, pixel=pixel, order=str(random.choice(['rgb', 'bgr'])), pitch=pitch,
                slant=random.choice([0, 9.46, -9.46, 12, 18.43, -15]) + random.uniform(-.5, .5),
                thickness=pitch * random.uniform(1.8, 3), ior=random.uniform(1.49, 1.59), place=random.uniform(-.5, .5),
                distance=random.uniform(.9, 1.6) * width * pixel, curved=o.curved,
                # The film is not quite in the focus, and light is scattered; mm on the film.
                focus=random.uniform(.93, 1.07), blur=random.uniform(.05, .12) * pitch)

def rough_description(panel):
    return dict(panel=dict(width=panel['width'], height=panel['height'], pixel_pitch_mm=panel['pixel'], subpixels=panel['order']),
                sheet=dict(arrangement='lenticular', pitch_mm=panel['pitch'] * (1 + random.uniform(-.01, .01)),
                           thickness_mm=panel['thickness'], ior=panel['ior'],
                           slant_degrees=panel['slant'] + random.uniform(-1.5, 1.5)),
                viewing_distance_mm=panel['distance'])

def calibrate(panel, rough, folder, views):
    """Lays the cards on the panel, one after another. Returns the sheet they give, and the readings."""
    given, picture, result = (os.path.join(folder, name) for name in ('rough.json', 'card.png', 'panel.json'))
    with open(given, 'w') as file:
        json.dump(rough, file)
    # The eye is not quite where it is supposed to be.
    eye = dict(panel, eye=random.normal(0, 3, 2), distance=panel['distance'] * random.normal(1, .01))
    command, readings = [os.environ['INTEGRAL'], 'lcd', '--panel', given, '--card', 'pitch'], []
    for number in 1, 2, 3:
        said = subprocess.run(command + ['-o', picture, '--json'], check=True, stdout=subprocess.PIPE, text=True)
        card = card_light(picture)
        if views:
            Image.open(picture).save(os.path.join(views, f'card{number}.png'))
            write_view(eye, card, os.path.join(views, f'seen{number}.png'), random)
        readings.append(reading(eye, card, json.loads(said.stdout)['lens_card']['blocks'], number == 3, random))
        command += ['--even', readings[-1]]
    subprocess.run(command + ['-o', result], check=True, stdout=subprocess.DEVNULL)
    with open(result) as file:
        return json.load(file)['sheet'], readings

def errors_of(sheet, panel):
    """Of the pitch, relative; of the slant, degrees; of the phase, as part of a lens."""
    turn = np.radians(sheet['slant_degrees'])
    place = (sheet['offset_mm'][0] * np.cos(turn) + sheet['offset_mm'][1] * np.sin(turn)) / sheet['pitch_mm']
    phase = place - panel['place']
    return sheet['pitch_mm'] / panel['pitch'] - 1, sheet['slant_degrees'] - panel['slant'], phase - round(phase)

errors = []
with tempfile.TemporaryDirectory() as folder:
    for number in range(o.panels):
        panel = random_panel()
        rough = rough_description(panel)
        before = errors_of(dict(rough['sheet'], offset_mm=[0, 0]), panel)
        try:
            sheet, readings = calibrate(panel, rough, folder, o.views if number == 0 else None)
        except subprocess.CalledProcessError as error:
            print(f'panel {number + 1}: {" ".join(error.cmd[4:])} is refused')
            errors.append((np.inf, np.inf, np.inf))
            continue
        errors.append(errors_of(sheet, panel))
        print(f'panel {number + 1}: {panel["width"]} pixels, {panel["width"] * panel["pixel"] / panel["pitch"]:.0f} lenses, '
              f'slant {panel["slant"]:.2f}, wrong by {100 * before[0]:+.2f}% and {before[1]:+.2f} degrees; then by '
              f'{100 * errors[-1][0]:+.4f}%, {errors[-1][1]:+.4f} degrees and {100 * errors[-1][2]:+.1f}% of a lens: '
              f'{" ".join(readings)}', flush=True)
errors = np.abs(np.array(errors))
for name, column, scale in ('pitch, %', 0, 100), ('slant, degrees', 1, 1), ('phase, % of a lens', 2, 100):
    part = scale * errors[:, column]
    print(f'{name}: median {np.median(part):.4f}, 95th percentile {np.quantile(part, .95, method="higher"):.4f}, '
          f'greatest {part.max():.4f}')
within = np.mean((errors[:, 0] <= o.most_pitch) & (errors[:, 1] <= o.most_slant))
print(f'{100 * within:.0f}% of {len(errors)} panels within {100 * o.most_pitch:g}% and {o.most_slant:g} degrees')
sys.exit(int(within < o.least_share))
