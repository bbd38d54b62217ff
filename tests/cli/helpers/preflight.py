# SPDX-License-Identifier: AGPL-3.0-or-later
# For test scripts: what a preflight checks of a PDF/X-4 (ISO 15930-7), read through qpdf.
#
#   preflight.py FILE.pdf PROFILE.icc    prints each broken rule; fails if there is one
#   preflight.py --image NAME FILE.pdf   writes the samples of the first page's image NAME
import json
import re
import subprocess
import sys
import xml.etree.ElementTree


def qpdf(*arguments):
    return subprocess.run(("qpdf",) + arguments, check=True, stdout=subprocess.PIPE).stdout


class Pdf:
    def __init__(self, path):
        self.path = path
        self.document = json.loads(qpdf("--json=1", path))
        self.objects = self.document["objects"]

    def get(self, value):
        is_reference = isinstance(value, str) and re.fullmatch(r"\d+ \d+ R", value)
        return self.objects[value] if is_reference else value

    def stream(self, reference):
        number = reference.split()[0]
        return qpdf("--show-object=" + number, "--filtered-stream-data", self.path)

    def pages(self):
        return [self.get(page["object"]) for page in self.document["pages"]]


broken = []


def rule(holds, what):
    if not holds:
        broken.append(what)


def inside(inner, outer):
    slack = 1e-3  # points
    return (inner[0] >= outer[0] - slack and inner[1] >= outer[1] - slack and
            inner[2] <= outer[2] + slack and inner[3] <= outer[3] + slack)


def check_document(pdf, catalog, profile):
    trailer = pdf.objects["trailer"]
    about = pdf.get(trailer["/Info"])
    rule("/Encrypt" not in trailer, "it is not encrypted")
    rule(len(trailer.get("/ID", [])) == 2, "it has an identifier")
    rule(about.get("/GTS_PDFXVersion") == "PDF/X-4", "Info names the version")
    rule(about.get("/Trapped") in ("/True", "/False"), "Info says whether it is trapped")
    rule(about.get("/Title"), "it has a title")
    for key in ("/CreationDate", "/ModDate"):
        rule(re.fullmatch(r"D:\d{14}(Z|[-+]\d\d'\d\d'?)", about.get(key, "")), key)
    for key in ("/AA", "/OpenAction", "/Names"):
        rule(key not in catalog, "its catalog has no " + key)
    intents = [pdf.get(i) for i in pdf.get(catalog.get("/OutputIntents", []))]
    ours = [i for i in intents if i["/S"] == "/GTS_PDFX"]
    rule(len(ours) == 1, "it has one output intent")
    for intent in ours:
        rule(intent.get("/OutputConditionIdentifier"), "the output condition has an identifier")
        rule(intent.get("/Info"), "the output condition is described")
        stored = intent["/DestOutputProfile"]
        rule(pdf.get(stored)["/N"] == 4, "the output profile is of four inks")
        rule(pdf.stream(stored) == open(profile, "rb").read(), "its bytes are the press's")


def check_metadata(pdf, catalog, about):
    reference = catalog.get("/Metadata")
    rule(reference, "it has metadata")
    if not reference:
        return
    rule("/Filter" not in pdf.get(reference), "metadata are not compressed")
    tree = xml.etree.ElementTree.fromstring(pdf.stream(reference))
    values = {e.tag: "".join(e.itertext()).strip() for e in tree.iter()}
    rdf = "{http://www.w3.org/1999/02/22-rdf-syntax-ns#}"
    rule(tree.find(rdf + "RDF") is not None, "metadata are RDF")
    adobe = "{http://ns.adobe.com/xap/1.0/"
    for name, pattern in {
            "{http://www.npes.org/pdfx/ns/id/}GTS_PDFXVersion": "PDF/X-4",
            "{http://ns.adobe.com/pdf/1.3/}Trapped": "True|False",
            "{http://purl.org/dc/elements/1.1/}title": ".+",
            adobe + "}CreateDate": r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ",
            adobe + "}ModifyDate": r"\d{4}-.*", adobe + "}MetadataDate": r"\d{4}-.*",
            adobe + "mm/}DocumentID": "uuid:[0-9a-f-]{36}", adobe + "mm/}VersionID": ".+",
            adobe + "mm/}RenditionClass": ".+"}.items():
        rule(re.fullmatch(pattern, values.get(name, "")), "XMP " + name)
    rule("/" + values["{http://ns.adobe.com/pdf/1.3/}Trapped"] == about["/Trapped"] and
         values["{http://purl.org/dc/elements/1.1/}title"] == about["/Title"] and
         all(re.sub("[-T:Z]", "", values[adobe + "}" + xmp]) == re.sub("[D:Z]", "", about[info])
             for xmp, info in (("CreateDate", "/CreationDate"), ("ModifyDate", "/ModDate"))),
         "XMP and Info agree")


def check_page(pdf, page):
    media, trim = page.get("/MediaBox"), page.get("/TrimBox")
    bleed = page.get("/BleedBox", media)
    rule(media and trim, "a page has MediaBox and TrimBox")
    rule("/ArtBox" not in page, "a page has not both TrimBox and ArtBox")
    rule(inside(trim, bleed) and inside(bleed, media), "its boxes lie within one another")
    resources = pdf.get(page["/Resources"])
    rule(not pdf.get(resources.get("/Font", {})), "it needs no font")
    for name, image in pdf.get(resources["/XObject"]).items():
        image = pdf.get(image)
        space = pdf.get(image["/ColorSpace"])
        kind = space if isinstance(space, str) else space[0]
        rule(kind in ("/DeviceCMYK", "/Separation"), name + " is in inks")
        rule("/SMask" not in image and "/Alternates" not in image, name + " is plain")
        rule(image.get("/Filter") == "/FlateDecode", name + " is compressed without loss")


def main():
    if sys.argv[1] == "--image":
        pdf = Pdf(sys.argv[3])
        images = pdf.get(pdf.get(pdf.pages()[0]["/Resources"])["/XObject"])
        sys.stdout.buffer.write(pdf.stream(images["/" + sys.argv[2]]))
        return
    pdf = Pdf(sys.argv[1])
    catalog = pdf.get(pdf.objects["trailer"]["/Root"])
    rule(1.3 < float(open(sys.argv[1], "rb").read(8)[5:]) <= 1.6, "it is PDF 1.4 to 1.6")
    check_document(pdf, catalog, sys.argv[2])
    check_metadata(pdf, catalog, pdf.get(pdf.objects["trailer"]["/Info"]))
    for page in pdf.pages():
        check_page(pdf, page)
    rule(pdf.pages(), "it has pages")
    for what in broken:
        print("not so: " + what)
    sys.exit(1 if broken else 0)


main()
