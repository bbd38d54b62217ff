# SPDX-License-Identifier: AGPL-3.0-or-later
# For test scripts: the samples of a TIFF whose strips are not compressed (tiffcp -c none).
#
#   tiff_samples.py FILE.tiff          writes the samples, 16 bits with the high byte first
#   tiff_samples.py FILE.tiff --channels A:B    the same of channels A to B - 1
#   tiff_samples.py FILE.tiff X Y      prints the samples of a pixel
#   tiff_samples.py FILE.tiff --pixels prints each kind of pixel once
#   tiff_samples.py A.tiff B.tiff      prints the greatest difference of two files' samples
import array
import struct
import sys


def read(path):
    """Width, samples a pixel, and the samples."""
    data = open(path, "rb").read()
    order = {b"II": "<", b"MM": ">"}[data[:2]]
    entry, = struct.unpack_from(order + "I", data, 4)
    count, = struct.unpack_from(order + "H", data, entry)
    tags = {}
    for k in range(count):
        at = entry + 2 + 12 * k
        tag, kind, values = struct.unpack_from(order + "HHI", data, at)
        form = {1: "B", 2: "c", 3: "H", 4: "I"}.get(kind)
        if not form:
            continue
        size = struct.calcsize(form) * values
        place = at + 8 if size <= 4 else struct.unpack_from(order + "I", data, at + 8)[0]
        tags[tag] = struct.unpack_from(order + str(values) + form, data, place)
    if tags.get(259, (1,))[0] != 1:
        sys.exit(path + ": its strips are compressed")
    raw = b"".join(data[a:a + n] for a, n in zip(tags[273], tags[279]))
    samples = array.array("H" if tags[258][0] == 16 else "B", raw)
    if samples.itemsize == 2 and (order == "<") != (sys.byteorder == "little"):
        samples.byteswap()
    return tags[256][0], tags[277][0], samples


def write(samples):
    if samples.itemsize == 2 and sys.byteorder == "little":
        samples.byteswap()
    sys.stdout.buffer.write(samples.tobytes())


def main():
    width, channels, samples = read(sys.argv[1])
    if sys.argv[2:3] == ["--channels"]:
        first, end = map(int, sys.argv[3].split(":"))
        parts = zip(*(samples[c::channels] for c in range(first, end)))
        write(array.array(samples.typecode, (s for pixel in parts for s in pixel)))
    elif len(sys.argv) == 4:
        at = channels * (int(sys.argv[3]) * width + int(sys.argv[2]))
        print(*samples[at:at + channels])
    elif sys.argv[2:] == ["--pixels"]:
        for pixel in sorted(set(zip(*(samples[c::channels] for c in range(channels))))):
            print(*pixel)
    elif len(sys.argv) == 3:
        other = read(sys.argv[2])
        if other[:2] != (width, channels) or len(other[2]) != len(samples):
            sys.exit("the files differ in size")
        print(max(abs(a - b) for a, b in zip(samples, other[2])))
    else:
        write(samples)


if __name__ == "__main__":
    main()
