package badlog.html

import java.security.MessageDigest
import java.util.Base64

/**
 * What is the same in all pages: the program that reads and draws the recording, and its styles.
 *
 * @param program the text of one classic script.
 * @param style the text of one style sheet.
 * @throws IllegalArgumentException when the style cannot stand inside its element as it is.
 */
public class PageParts(program: String, style: String) {
    internal val program: ByteArray = lines(program).encodeToByteArray()
    internal val style: ByteArray = lines(style).encodeToByteArray()

    /** The program as it stands in a page. */
    internal val packedProgram: ByteArray = packed(this.program)

    init {
        require(!style.contains("</style", ignoreCase = true)) { "\"</style\" stands in the page's style." }
    }

    /** The Content-Security-Policy of a page with these parts: nothing from the network, no other script or style. */
    internal val policy: String
        get() = "default-src 'none'; script-src '${hash(UNPACKING.encodeToByteArray())}' '${hash(program)}'; worker-src blob:; " +
            "style-src '${hash(style)}'; " +
            "img-src data: blob:; base-uri 'none'; form-action 'none'"

    public companion object {
        /** The page that this version of badlog brings along. */
        public fun bundled(): PageParts = PageParts(resource("page.js"), resource("page.css"))

        private fun resource(name: String): String {
            val stream = PageParts::class.java.getResourceAsStream("/badlog/page/$name")
            checkNotNull(stream) { "$name is missing in this build of badlog." }
            return stream.use { it.readBytes().decodeToString() }
        }

        // A browser reads every end of line as LF, and takes its hash of that.
        private fun lines(text: String) = text.replace("\r\n", "\n").replace('\r', '\n')

        private fun hash(bytes: ByteArray): String {
            val digest = MessageDigest.getInstance("SHA-256").digest(bytes)
            return "sha256-" + Base64.getEncoder().encodeToString(digest)
        }
    }
}
