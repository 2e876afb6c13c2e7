package badlog.html

import java.io.ByteArrayOutputStream
import java.util.zip.Deflater
import java.util.zip.GZIPOutputStream

/** Stands between the style sheet and the program where they are packed; no style sheet may have it. */
internal const val SEPARATOR = '\u0000'

/**
 * The [text] of a style sheet, [SEPARATOR] and a program as a page carries it: a gzip stream in [base85], less than half its size.
 * [UNPACKING] makes a style sheet and a script of it again.
 */
internal fun packed(text: String): ByteArray {
    val gzip = ByteArrayOutputStream()
    val tight = object : GZIPOutputStream(gzip) {
        init {
            def.setLevel(Deflater.BEST_COMPRESSION)
        }
    }
    tight.use { it.write(text.encodeToByteArray()) }
    return base85(gzip.toByteArray())
}

/**
 * [bytes] as text that may stand in a page: five characters for four bytes, where base64 needs four for three. A number of
 * four bytes is five digits to the base 85, the highest first; `n` bytes that are left over are `n + 1` digits. The digits are the
 * characters from `(` to `|`, with `!` in place of `<`, so that nothing in them can end an element.
 */
internal fun base85(bytes: ByteArray): ByteArray {
    val text = ByteArrayOutputStream(bytes.size / GROUP_BYTES * GROUP_DIGITS + GROUP_DIGITS)
    val digits = ByteArray(GROUP_DIGITS)
    for (from in bytes.indices step GROUP_BYTES) {
        var number = 0L
        for (i in from until from + GROUP_BYTES) number = number shl 8 or (if (i < bytes.size) bytes[i].toLong() and 0xff else 0)
        for (place in GROUP_DIGITS - 1 downTo 0) {
            val digit = FIRST_DIGIT + (number % BASE).toInt()
            digits[place] = (if (digit == '<'.code) '!'.code else digit).toByte()
            number /= BASE
        }
        text.write(digits, 0, minOf(bytes.size - from, GROUP_BYTES) + 1)
    }
    return text.toByteArray()
}

private const val BASE = 85
private const val GROUP_BYTES = 4
private const val GROUP_DIGITS = 5
private const val FIRST_DIGIT = '('.code

/**
 * The one script that a page has in plain text. The policy knows the hashes of program and style, so the browser takes what this
 * unpacks only while it is the very text that the exporter packed.
 */
internal const val UNPACKING = """/* Unpacks the program of this page, which holds uPlot (MIT license) and parts of Kotlin's standard library
(copyright JetBrains s.r.o., Apache License 2.0); their notices stand in it. */
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
  if (!self.DecompressionStream) {
    fail('This browser is too old. This page needs Chrome 80, Edge 80, Firefox 113, Safari 16.4 or newer.');
    return;
  }
  const unpack = async element => {
    const text = element.textContent;
    const bytes = new Uint8Array(Math.floor(text.length * 4 / 5));
    const digit = i => i >= text.length ? 84 : text[i] === '!' ? 20 : text.charCodeAt(i) - 40;
    for (let i = 0, at = 0; i < text.length; i += 5) {
      let number = 0;
      for (let j = i; j < i + 5; j++) number = number * 85 + digit(j);
      for (let shift = 24; shift >= 0 && at < bytes.length; shift -= 8) bytes[at++] = number / 2 ** shift;
    }
    return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))).text();
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
    document.body.append(script);
  }).catch(() => fail('This page is not complete. Something of it was damaged in copying; export it again.'));
})();
"""
