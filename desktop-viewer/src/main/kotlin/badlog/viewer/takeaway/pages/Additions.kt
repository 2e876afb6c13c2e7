package badlog.viewer.takeaway.pages

import badlog.html.PageAdditions
import badlog.report.page.pageAdditions
import badlog.viewer.findings.findingsOf
import badlog.viewer.recording.OpenRecording
import java.io.IOException
import java.nio.file.Path

/**
 * What the pages show besides the recordings: the formulas that make a topic there, and what the rules find.
 *
 * @param known recordings that are read already.
 * @param definitions the formulas.
 * @param library the folder of logs, whose rules count.
 */
internal class Additions(known: List<OpenRecording>, private val definitions: List<String>, private val library: Path?) {
    private val known = known.associateBy { it.file }

    /** Those of the page of [log]; none where it cannot be read, which whoever makes the page tells. */
    fun of(log: Path): PageAdditions = try {
        val recording = known[log] ?: OpenRecording.read(log, { definitions })
        val working = recording.formulas.filter { it.topic != null }.map { it.definition }
        pageAdditions(working, findingsOf(recording.logged, log, library).all)
    } catch (_: IOException) {
        PageAdditions()
    } catch (_: OutOfMemoryError) {
        PageAdditions()
    }
}
