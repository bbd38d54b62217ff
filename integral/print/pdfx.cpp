// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/print/pdfx.h"

#include "integral/io/markup.h"
#include "integral/print/colour_profile.h"

#include <stdexcept>

namespace integral {
namespace {

constexpr char producer[] = "povray-integral", version[] = "PDF/X-4";

std::string formatted_time(std::time_t time, const char* form)
{
    std::tm parts;
    char text[64];
    if (!gmtime_r(&time, &parts) || std::strftime(text, sizeof text, form, &parts) == 0)
        throw std::invalid_argument("the document's time has no date");
    return text;
}

/// A digest of 32 hexadecimal digits in the form of a UUID.
std::string uuid(const std::string& digest)
{
    return "uuid:" + digest.substr(0, 8) + "-" + digest.substr(8, 4) + "-" + digest.substr(12, 4) +
           "-" + digest.substr(16, 4) + "-" + digest.substr(20, 12);
}

std::string element(const std::string& name, const std::string& text)
{
    return "<" + name + ">" + markup_text(text) + "</" + name + ">\n";
}

std::string xmp(const PdfxDocument& document, const std::string& identifier)
{
    const std::string time = formatted_time(document.created, "%Y-%m-%dT%H:%M:%SZ");
    return "<?xpacket begin=\"\xef\xbb\xbf\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>\n"
           "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\">\n"
           "<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">\n"
           "<rdf:Description rdf:about=\"\"\n"
           " xmlns:dc=\"http://purl.org/dc/elements/1.1/\"\n"
           " xmlns:pdf=\"http://ns.adobe.com/pdf/1.3/\"\n"
           " xmlns:pdfxid=\"http://www.npes.org/pdfx/ns/id/\"\n"
           " xmlns:xmp=\"http://ns.adobe.com/xap/1.0/\"\n"
           " xmlns:xmpMM=\"http://ns.adobe.com/xap/1.0/mm/\">\n" +
           element("dc:format", "application/pdf") +
           "<dc:title><rdf:Alt><rdf:li xml:lang=\"x-default\">" + markup_text(document.title) +
           "</rdf:li></rdf:Alt></dc:title>\n" + element("pdf:Producer", producer) +
           element("pdf:Trapped", "False") + element("pdfxid:GTS_PDFXVersion", version) +
           element("xmp:CreateDate", time) + element("xmp:ModifyDate", time) +
           element("xmp:MetadataDate", time) + element("xmpMM:DocumentID", identifier) +
           element("xmpMM:InstanceID", identifier) + element("xmpMM:VersionID", "1") +
           element("xmpMM:RenditionClass", "default") +
           "</rdf:Description>\n</rdf:RDF>\n</x:xmpmeta>\n<?xpacket end=\"r\"?>";
}

} // namespace

PdfxEntries add_pdfx(PdfFile& pdf, const PdfxDocument& document)
{
    const int profile = pdf.add_stream("/N 4", document.profile);
    const int metadata = pdf.add_plain_stream("/Type /Metadata /Subtype /XML",
                                              xmp(document, uuid(pdf.digest())));
    std::string press = profile_description(document.profile);
    if (press.empty())
        press = "CMYK";
    const std::string date = "(" + formatted_time(document.created, "D:%Y%m%d%H%M%SZ") + ")";
    PdfxEntries entries;
    // Custom: the profile stands for itself, not for a name in a registry.
    entries.catalog = " /OutputIntents [ << /Type /OutputIntent /S /GTS_PDFX "
                      "/OutputConditionIdentifier (Custom) /OutputCondition " +
                      pdf_text(press) + " /Info " + pdf_text(press) + " /DestOutputProfile " +
                      reference(profile) + " >> ] /Metadata " + reference(metadata);
    entries.about = "<< /Title " + pdf_text(document.title) + " /Producer (" + producer +
                    ") /CreationDate " + date + " /ModDate " + date + " /GTS_PDFXVersion (" +
                    version + ") /Trapped /False >>";
    return entries;
}

} // namespace integral
