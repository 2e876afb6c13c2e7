package badlog.html

import java.io.ByteArrayOutputStream
import java.util.Base64
import java.util.zip.Deflater
import java.util.zip.GZIPOutputStream

/** Stands between the style sheet and the program where they are packed; no style sheet may have it. */
internal const val SEPARATOR = '\u0000'

/**
 * The [text] of a style sheet, [SEPARATOR] and a program as a page carries it: the base64 of a gzip stream, half its size.
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
    return Base64.getEncoder().encode(gzip.toByteArray())
}

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
    const text = atob(element.textContent);
    const bytes = new Uint8Array(text.length);
    for (let i = 0; i < bytes.length; i++) bytes[i] = text.charCodeAt(i);
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
