package badlog.exporter

import java.security.MessageDigest
import java.util.Base64
import java.util.zip.GZIPInputStream

/**
 * The parts shared by all pages: the program that reads and draws the recording, and its styles.
 *
 * @param program the text of one classic script.
 * @param style the text of the program's style sheet; it is packed with the program.
 * @param waitingStyle the text of the style sheet that applies before the program runs, or if it does not run.
 * @throws IllegalArgumentException if one of them cannot be embedded in a page unchanged.
 */
class PageParts private constructor(
    private val program: String,
    private val style: String,
    internal val waitingStyle: String,
    gzip: ByteArray?,
) {
    constructor(
        program: String,
        style: String,
        waitingStyle: String = "",
    ) : this(lines(program), lines(style), lines(waitingStyle), null)

    init {
        require(!waitingStyle.contains("</style", ignoreCase = true)) { "\"</style\" stands in the page's style." }
        require(SEPARATOR !in style) { "The page's style has a character U+0000." }
    }

    /** The program and its style in the form embedded in a page. */
    internal val packedProgram: ByteArray = gzip?.let(Base64.getEncoder()::encode) ?: packed(style + SEPARATOR + program)

    /**
     * Returns the Content-Security-Policy of a page with these parts. It allows no other script or style, and only the servers of
     * [network]. It allows videos that the reader opens and, if [hasVideo], a video from the page's own location.
     */
    internal fun policy(hasVideo: Boolean, network: PageNetwork = PageNetwork.NONE): String {
        val scripts = "script-src '${hash(UNPACKING)}' '${hash(program)}'; worker-src blob:; "
        val others = "style-src '${hash(waitingStyle)}' '${hash(style)}'; " +
            "img-src data: blob:; media-src blob:${if (hasVideo) " 'self'" else ""}; base-uri 'none'; form-action 'none'"
        return "default-src 'none'; $scripts${network.policy}$others"
    }

    companion object {
        /** Returns the parts that are built into this version of badlog. */
        fun bundled(): PageParts {
            // The build compresses it better than would be fast enough here.
            val gzip = resource("page.gz")
            val text = GZIPInputStream(gzip.inputStream()).use { it.readBytes().decodeToString() }
            val waitingStyle = resource("waiting.css").decodeToString()
            return PageParts(text.substringAfter(SEPARATOR), text.substringBefore(SEPARATOR), waitingStyle, gzip)
        }

        private fun resource(name: String): ByteArray {
            val stream = PageParts::class.java.getResourceAsStream("/badlog/page/$name")
            checkNotNull(stream) { "$name is missing in this build of badlog." }
            return stream.use { it.readBytes() }
        }

        // A browser reads every line end as LF before it calculates the hash.
        private fun lines(text: String) = text.replace("\r\n", "\n").replace('\r', '\n')

        private fun hash(text: String): String {
            val digest = MessageDigest.getInstance("SHA-256").digest(text.encodeToByteArray())
            return "sha256-" + Base64.getEncoder().encodeToString(digest)
        }
    }
}
