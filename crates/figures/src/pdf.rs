//! Figures as PDFs whose text can be searched and copied.
//!
//! Its letters are outlines, as in the SVG, so that it looks the same. Over them each label is written once more in
//! characters, stretched to the label's box and invisible (text rendering mode 3), as scanned pages carry their words.
//! The font of that text has one glyph, which is empty. Signs are those of a keyboard, as the program prints them:
//! `k' = -0.4`, `SRO-`; what is copied can be pasted into a case.

use std::collections::BTreeMap;

use pdf_writer::types::{SystemInfo, TextRenderingMode, UnicodeCmap};
use pdf_writer::{Content, Finish, Name, Pdf, Rect, Ref, Str, TextStr};
use svg2pdf::ConversionOptions;

use crate::Figure;
use crate::render::RenderError;
use crate::scene::Label;

/// Points of a page for a unit of the SVG.
const POINT: f32 = 0.75;
/// The type size of the invisible text, and the width of its characters in thousandths of it.
const SIZE: f32 = 8.5;
const ADVANCE: f32 = 500.0;
const FIGURE: Name = Name(b"Figure");
const FONT: Name = Name(b"Words");
const BLANK: Name = Name(b"blank");

impl Figure {
    /// The figure as a PDF page of its own size; a unit of the SVG is 0.75 pt. Its text can be searched and copied.
    ///
    /// # Errors
    /// If the writer fails; no figure of this crate makes it fail.
    pub fn pdf(&self) -> Result<Vec<u8>, RenderError> {
        let mut last = Ref::new(1);
        let mut next = || last.bump();
        let [catalog, pages, page, content, info] = [next(), next(), next(), next(), next()];
        let font = [next(), next(), next()];
        let (drawing, root) = svg2pdf::to_chunk(&self.tree()?, ConversionOptions::default())
            .map_err(|error| RenderError::Pdf(error.to_string()))?;
        let mut renamed = BTreeMap::new();
        let drawing = drawing.renumber(|old| *renamed.entry(old).or_insert_with(&mut next));

        let (width, height) = (POINT * self.size.0 as f32, POINT * self.size.1 as f32);
        let codes = Codes::of(&self.labels);
        let mut pdf = Pdf::new();
        pdf.catalog(catalog).pages(pages).lang(TextStr("en"));
        pdf.pages(pages).kids([page]).count(1);
        let mut leaf = pdf.page(page);
        leaf.media_box(Rect::new(0.0, 0.0, width, height)).parent(pages).contents(content);
        let mut resources = leaf.resources();
        resources.x_objects().pair(FIGURE, renamed[&root]);
        resources.fonts().pair(FONT, font[0]);
        resources.finish();
        leaf.finish();

        let mut stream = Content::new();
        stream.save_state().transform([width, 0.0, 0.0, height, 0.0, 0.0]).x_object(FIGURE).restore_state();
        stream.begin_text().set_font(FONT, SIZE).set_text_rendering_mode(TextRenderingMode::Invisible);
        self.labels.iter().for_each(|label| codes.write(label, height, &mut stream));
        stream.end_text();
        pdf.stream(content, &stream.finish());
        codes.font(font, &mut pdf);
        pdf.document_info(info).title(TextStr(&self.title)).producer(TextStr("standfast"));
        pdf.extend(&drawing);
        Ok(pdf.finish())
    }
}

/// A label's characters as the program prints them.
fn typed(label: &Label) -> String {
    let plain = label.text.chars().map(|character| match character {
        '−' | '₋' => '-',
        '₊' => '+',
        '′' => '\'',
        other => other,
    });
    plain.collect::<String>().replace('″', "''")
}

/// The characters in use, each under a code of the invisible font.
struct Codes(BTreeMap<char, u8>);

impl Codes {
    /// A font of this kind has 255 codes; characters beyond them are left out.
    fn of(labels: &[Label]) -> Codes {
        let mut codes = BTreeMap::new();
        for character in labels.iter().flat_map(|label| typed(label).chars().collect::<Vec<_>>()) {
            let code = u8::try_from(codes.len() + 1);
            if let (false, Ok(code)) = (codes.contains_key(&character), code) {
                codes.insert(character, code);
            }
        }
        Codes(codes)
    }

    /// Writes a label, as wide as its box and in the middle of its height.
    fn write(&self, label: &Label, page_height: f32, stream: &mut Content) {
        let text: Vec<u8> =
            typed(label).chars().filter_map(|character| self.0.get(&character).copied()).collect();
        let natural = text.len() as f32 * ADVANCE / 1000.0 * SIZE;
        if natural == 0.0 {
            return;
        }
        let wide = POINT * (label.rect.x1 - label.rect.x0) as f32;
        let (x, middle) = (POINT * label.rect.x0 as f32, POINT * label.rect.centre().1 as f32);
        stream.set_horizontal_scaling(100.0 * wide / natural);
        stream.set_text_matrix([1.0, 0.0, 0.0, 1.0, x, page_height - middle - 0.3 * SIZE]);
        stream.show(Str(&text));
    }

    /// A font whose every character is blank, and the characters that its codes stand for.
    fn font(&self, [font, glyph, unicode]: [Ref; 3], pdf: &mut Pdf) {
        let count = self.0.len() as u8;
        let mut blank = pdf.type3_font(font);
        blank.bbox(Rect::new(0.0, -250.0, ADVANCE, 750.0)).matrix([0.001, 0.0, 0.0, 0.001, 0.0, 0.0]);
        blank.char_procs().pair(BLANK, glyph);
        blank.encoding_custom().differences().consecutive(1, (0..count).map(|_| BLANK));
        blank.first_char(1).last_char(count.max(1)).widths((0..count.max(1)).map(|_| ADVANCE));
        blank.resources();
        blank.to_unicode(unicode);
        blank.finish();
        let mut empty = Content::new();
        empty.start_color_glyph(ADVANCE);
        pdf.stream(glyph, &empty.finish());

        let info = SystemInfo { registry: Str(b"Adobe"), ordering: Str(b"UCS"), supplement: 0 };
        let mut map = UnicodeCmap::<u8>::new(Name(b"Words"), info);
        self.0.iter().for_each(|(&character, &code)| map.pair(code, character));
        pdf.cmap(unicode, &map.finish());
    }
}
