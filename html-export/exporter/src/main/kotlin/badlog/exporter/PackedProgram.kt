package badlog.exporter

import java.io.ByteArrayOutputStream
import java.util.zip.Deflater
import java.util.zip.GZIPOutputStream

/** Separates the style sheet from the program in the packed text; no style sheet may contain it. */
internal const val SEPARATOR = '\u0000'

/**
 * Returns [text], which is a style sheet, [SEPARATOR] and a program, in the form embedded in a page: a gzip stream in [base122],
 * less than half its size. [UNPACKING] turns it back into a style sheet and a script.
 */
internal fun packed(text: String): ByteArray {
    val gzip = ByteArrayOutputStream()
    val tight = object : GZIPOutputStream(gzip) {
        init {
            def.setLevel(Deflater.BEST_COMPRESSION)
        }
    }
    tight.use { it.write(text.encodeToByteArray()) }
    return base122(gzip.toByteArray())
}

/**
 * Returns [bytes] as text that is safe in a page: 81 characters for 70 bytes, compared with 94 for base64. It works like basE91, with
 * more digits: 13 bits of the bytes, lowest first, are a number of two [DIGITS], the lower one first; 14 bits if there is room for one
 * more.
 */
internal fun base122(bytes: ByteArray): ByteArray {
    val text = ByteArrayOutputStream(bytes.size + bytes.size / 5)
    var bits = 0
    var count = 0
    for (byte in bytes) {
        bits = bits or (byte.toInt() and 0xff shl count)
        count += 8
        if (count <= SURE_BITS) continue
        val low = bits and (1 shl SURE_BITS) - 1
        val size = if (low >= BASE * BASE - (1 shl SURE_BITS)) SURE_BITS else SURE_BITS + 1
        val number = bits and (1 shl size) - 1
        bits = bits ushr size
        count -= size
        text.write(DIGITS[number % BASE])
        text.write(DIGITS[number / BASE])
    }
    if (count > 0) text.write(DIGITS[bits % BASE])
    if (count > 7 || bits >= BASE) text.write(DIGITS[bits / BASE])
    return text.toByteArray()
}

/**
 * ASCII without the characters that HTML changes, U+0000 and the carriage return, and without `<`, which could end the text. A line feed is
 * safe, even if a program that copies the page puts a carriage return before it. Form feed, U+001A and escape are excluded because of other
 * readers of text files: they mean a new page, the end of a file under DOS, and commands to a terminal. Excluding those three costs 1.6 kB
 * of a page.
 */
private val DIGITS: List<Int> = (1..127) - listOf(0x0c, '\r'.code, 0x1a, 0x1b, '<'.code)

private const val BASE = 122
private const val SURE_BITS = 13

/**
 * The only script that a page has in plain text. The policy contains the hashes of program and style, so the browser accepts
 * what this unpacks only if it is exactly the text that the exporter packed.
 */
internal val UNPACKING: String = """/* Unpacks the program of this page; the licenses of what it holds stand in it. */
(() => {
  const fail = text => {
    const line = document.createElement('p');
    line.className = 'screen';
    line.textContent = text;
    const page = document.getElementById('page');
    page.textContent = '';
    page.append(line);
    document.documentElement.dataset.state = 'failed';
  };
  addEventListener('error', event => document.documentElement.dataset.state || fail('Something went wrong: ' + event.message));
  if (!self.DecompressionStream) {
    fail('This browser is too old. This page needs Chrome 80, Edge 80, Firefox 113, Safari 16.4 or newer.');
    return;
  }
  const values = [];
  for (let code = 1, value = 0; code < 128; code++) if (![12, 13, 26, 27, 60].includes(code)) values[code] = value++;
  const unpack = async element => {
    const digits = element.textContent, bytes = new Uint8Array(digits.length);
    let bits = 0, count = 0, low = -1, size = 0;
    for (let i = 0; i < digits.length; i++) {
      const digit = values[digits.charCodeAt(i)];
      if (low < 0) low = digit;
      else {
        low += digit * 122;
        bits |= low << count;
        count += (low & 8191) > 6691 ? 13 : 14;
        for (; count > 7; count -= 8, bits >>= 8) bytes[size++] = bits;
        low = -1;
      }
    }
    if (low >= 0) bytes[size++] = bits | low << count;
    return new Response(new Blob([bytes.subarray(0, size)]).stream().pipeThrough(new DecompressionStream('gzip'))).text();
  };
  const packed = document.getElementById('packed-additions');
  Promise.all([
    unpack(document.getElementById('packed')),
    packed ? unpack(packed).catch(() => '') : null,
  ]).then(([text, additions]) => {
    if (packed) {
      const data = document.createElement('script');
      data.type = 'application/json';
      data.id = 'additions';
      data.textContent = additions;
      packed.replaceWith(data);
    }
    const end = text.indexOf('\0');
    const style = document.createElement('style');
    style.textContent = text.slice(0, end);
    document.head.append(style);
    const script = document.createElement('script');
    script.id = 'program';
    script.textContent = text.slice(end + 1);
    document.head.append(script);
  }).catch(() => fail('This page is not complete. Something of it was damaged in copying; export it again.'));
})();
""".replace(Regex("\n +"), "\n")
