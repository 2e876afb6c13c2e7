package badlog.exporter

import java.io.ByteArrayOutputStream
import java.util.Base64
import java.util.zip.Deflater
import java.util.zip.GZIPOutputStream

/** The character between the style sheet and the program in the packed text; no style sheet may contain it. */
internal const val SEPARATOR = '\u0000'

/**
 * Returns [text] in the form embedded in a page: a gzip stream in base64. [UNPACKING] turns a style sheet, [SEPARATOR] and a program back
 * into a style sheet and a script.
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
 * The only script that a page contains in plain text. The policy has the hashes of program and style, so the browser accepts the unpacked
 * text only if it is exactly the text that the exporter packed.
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
  const unpack = async element => {
    const bytes = Uint8Array.from(atob(element.textContent), character => character.charCodeAt(0));
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
    document.head.append(script);
  }).catch(() => fail('This page is not complete. Something of it was damaged in copying; export it again.'));
})();
""".replace(Regex("\n +"), "\n")
