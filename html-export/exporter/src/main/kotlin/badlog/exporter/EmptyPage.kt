package badlog.exporter

import badlog.files.AtomicFile
import badlog.protocol.PageAdditions
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import java.nio.file.Files
import java.nio.file.Path

/**
 * A page without a log: whoever has it opens logs with it, in any browser, without installing anything. It runs the built-in rules, and
 * holds a sample.
 *
 * @param parts the program and the styles of the page.
 */
class EmptyPage(private val parts: PageParts = PageParts.bundled()) {
    /**
     * Writes the page to [output], whose folder is created if necessary.
     *
     * @param isServed whether the page is for a web server on a robot: it lists the logs that this server has, and may ask it for them. Any
     *   other page may not use a network at all.
     * @throws ExportException if it cannot be written.
     */
    fun write(output: Path, isServed: Boolean = false) {
        val page = output.toAbsolutePath().normalize()
        checkWritable(page, emptyList())
        writing(page) {
            Files.createDirectories(page.parent)
            AtomicFile(page).use { file ->
                val writer = PageWriter(file.out, parts)
                writer.begin("badlog", isServed = isServed)
                writer.program(PageAdditions(rules = RuleSet.BUILT_IN))
                ExportThreads().use { threads ->
                    val sample = checkNotNull(EmptyPage::class.java.getResourceAsStream("/badlog/page/$SAMPLE")) {
                        "$SAMPLE is missing in this build of badlog."
                    }
                    sample.use { writer.sample(SAMPLE) { out -> RawEmbedding(threads, out).embed(it) } }
                }
                writer.end(isServed)
                file.commit()
            }
        }
    }

    companion object {
        /** The usual name of the page. */
        const val NAME: String = "badlog.html"

        /** The usual name of the page for a web server on a robot. Called `index.html`, it would hide the list of logs that it asks for. */
        const val SERVED_NAME: String = "logs.html"

        private const val SAMPLE = "brownout.bag"
    }
}
