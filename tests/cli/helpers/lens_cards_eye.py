# SPDX-License-Identifier: AGPL-3.0-or-later
# Simulates an eye before a panel under a lens sheet, and a person who reads the cards of `integral
# lcd --card pitch`. Shares no code with the program: traces the eye's rays through slanted
# cylindrical lenses to the subpixels of the card's PNG, with a blur and noise. Selects as a person
# does: the bar without bands, or two neighbours that look the same.
#
#   lens_cards_eye.py CARD.png BARS.json TRUTH.json [--view FILE.png]
#
# Prints the bars, as --even takes them. BARS.json: what the command printed with --json. TRUTH.json:
# the description of the panel as it is. --view: writes what the eye sees.
import argparse, json
import numpy as np
from PIL import Image

luminance = np.array([.2126, .7152, .0722])
noise = .01 # of the eye's comparison of two areas, of full light

def film_seen(panel, x, y, random):
    """Points on the film of rays from the eye through points of the lenses; mm, y upwards."""
    p, n, t = panel['pitch'], panel['ior'], panel['thickness']
    turn = np.radians(panel['slant'])
    across = np.array([np.cos(turn), np.sin(turn)])
    h = x * across[0] + y * across[1] - panel['place'] * p
    h -= p * np.round(h / p) # from the lens's axis
    if panel['curved']: # a cylinder, with its aberrations
        radius = t * panel['focus'] * (n - 1) / n
        depth = np.sqrt(radius**2 - h**2)
        z, slope, flat = radius - depth, h / radius, depth / radius
    else: # a thin lens: the ray through its axis, and others that meet it before the film or behind
        x, y, z, slope, flat = x - h * across[0], y - h * across[1], 0 * h, 0 * h, 1 + 0 * h
    ray = np.stack([x - panel['eye'][0], y - panel['eye'][1], z + panel['distance']])
    ray /= np.sqrt((ray**2).sum(0))
    normal = np.stack([slope * across[0], slope * across[1], -flat]) # towards the eye
    cosine = -(ray * normal).sum(0)
    inner = np.sqrt(1 - (1 - cosine**2) / n**2)
    ray = ray / n + (cosine / n - inner) * normal
    way = (t - z) / ray[2]
    spread = panel['blur'] * random.standard_normal((2, len(x)))
    if not panel['curved']:
        spread += (1 - 1 / panel['focus']) * h * across[:, None]
    return x + way * ray[0] + spread[0], y + way * ray[1] + spread[1]

def light_seen(panel, card, x, y, random):
    """Colours that the eye sees at points of the lenses: those of the subpixels that the rays meet."""
    u, v = film_seen(panel, x, y, random)
    column, row = u / panel['pixel'] + panel['width'] / 2, panel['height'] / 2 - v / panel['pixel']
    i = np.clip(column.astype(int), 0, panel['width'] - 1)
    j = np.clip(row.astype(int), 0, panel['height'] - 1)
    third = 3 * (column - np.floor(column))
    stripe = np.clip(third.astype(int), 0, 2)
    channel = stripe if panel['order'] == 'rgb' else 2 - stripe
    # Between the subpixels is a dark frame.
    lit = (np.abs(third - stripe - .5) < .44) & (np.abs(row - np.floor(row) - .5) < .46)
    light = np.zeros((len(x), 3))
    light[np.arange(len(x)), channel] = 3 * lit * card[j, i, channel]
    return light

def card_light(path):
    v = np.arange(256) / 255
    light = np.where(v <= .04045, v / 12.92, ((v + .055) / 1.055) ** 2.4).astype(np.float32)
    return light[np.asarray(Image.open(path).convert('RGB'))]

def profile(panel, card, bar, upright, segments, halves, number, random):
    """The light of a bar's parts, along it and in its halves, as the eye sees it, with noise; and
    the mean variance of these figures, as they are of few rays and noisy."""
    along, across = random.random((2, number))
    half = (across * halves).astype(int)
    index, cells = half * segments + (along * segments).astype(int), segments * halves
    along = .04 + .92 * along # the outermost lenses show what is beside the bar
    across = (half + .1 + .8 * (across * halves - half)) / halves
    if upright:
        along, across = across, along
    x = (bar['left'] + along * bar['width'] - panel['width'] / 2) * panel['pixel']
    y = (panel['height'] / 2 - bar['top'] - across * bar['height']) * panel['pixel']
    seen = light_seen(panel, card, x, y, random) @ luminance
    rays = np.bincount(index, minlength=cells)
    mean = np.bincount(index, seen, cells) / rays
    variance = np.mean((np.bincount(index, seen**2, cells) / rays - mean**2) / rays)
    return (mean + noise * random.standard_normal(cells)).reshape(halves, segments), variance + noise**2

def unevenness(panel, card, bar, upright, random):
    light, variance = profile(panel, card, bar, upright, 40, 2, 16000, random)
    return np.sqrt(max(0, light.var(1).mean() - variance))

def even_bars(panel, card, block, random):
    uneven = [unevenness(panel, card, bar, block['upright'], random) for bar in block['bars']]
    best = int(np.argmin(uneven))
    second = min((k for k in (best - 1, best + 1) if 0 <= k < len(uneven)), key=lambda k: uneven[k])
    return [best, second] if uneven[second] < 2 * uneven[best] else [best]

def brightest_bars(panel, card, block, random):
    light = np.array([profile(panel, card, bar, False, 1, 1, 4000, random)[0][0, 0] for bar in block['bars']])
    best, count = int(np.argmax(light)), len(light)
    before, after = light[best - 1], light[(best + 1) % count]
    second = (best - 1) % count if before > after else (best + 1) % count
    off = .5 * abs(after - before) / (2 * light[best] - before - after)
    return [best, second] if off > .25 else [best]

def reading(panel, card, blocks, is_last, random):
    """The bars that a person selects, as --even takes them."""
    read = brightest_bars if is_last else even_bars
    return ','.join(str(block['bars'][k]['number']) for block in blocks for k in read(panel, card, block, random))

def write_view(panel, card, path, random, width=1440, rays=25):
    """A picture of the panel, as the eye sees it."""
    height = width * panel['height'] // panel['width']
    pixel = panel['width'] * panel['pixel'] / width
    total = np.zeros((width * height, 3))
    i, j = np.meshgrid(np.arange(width), np.arange(height))
    for _ in range(rays):
        x = (i.ravel() + random.random(width * height) - width / 2) * pixel
        y = (height / 2 - j.ravel() - random.random(width * height)) * pixel
        total += light_seen(panel, card, x, y, random) / rays
    v = np.clip(total, 0, 1)
    v = np.where(v <= .0031308, 12.92 * v, 1.055 * v ** (1 / 2.4) - .055)
    Image.fromarray((255 * v + .5).astype(np.uint8).reshape(height, width, 3)).save(path)

def described(document):
    """A panel of a description, with an ordinary blur and the eye where it should be."""
    film, sheet = document['panel'], document['sheet']
    turn = np.radians(sheet['slant_degrees'])
    offset = sheet.get('offset_mm', [0, 0])
    return dict(width=film['width'], height=film['height'], pixel=np.ravel(film['pixel_pitch_mm'])[0],
                order=film['subpixels'], pitch=sheet['pitch_mm'], slant=sheet['slant_degrees'],
                thickness=sheet['thickness_mm'], ior=sheet['ior'],
                place=(offset[0] * np.cos(turn) + offset[1] * np.sin(turn)) / sheet['pitch_mm'],
                distance=document['viewing_distance_mm'], focus=1.03, blur=.08 * sheet['pitch_mm'],
                eye=(0, 0), curved=False)

if __name__ == '__main__':
    arguments = argparse.ArgumentParser()
    for name in 'card', 'bars', 'truth':
        arguments.add_argument(name)
    arguments.add_argument('--view')
    o = arguments.parse_args()
    random = np.random.default_rng(1)
    with open(o.truth) as truth, open(o.bars) as bars:
        panel, about = described(json.load(truth)), json.load(bars)['lens_card']
    card = card_light(o.card)
    if o.view:
        write_view(panel, card, o.view, random)
    print(reading(panel, card, about['blocks'], about['card'] == 3, random))
