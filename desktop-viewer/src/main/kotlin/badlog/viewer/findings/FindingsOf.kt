package badlog.viewer.findings

import badlog.analysis.LogView
import badlog.report.rules.over
import java.nio.file.Path

/**
 * Runs the rules for [file], which was read as [view], over it. Takes its time; interrupting the thread gives up.
 *
 * @param library the folder of logs, see [RulesFor.of].
 */
internal fun findingsOf(view: LogView, file: Path, library: Path?): FindingList {
    val rules = RulesFor.of(file, library)
    return try {
        val found = rules.set.over(view, file.fileName.toString())
        FindingList(found.findings, found.skipped, rules.file, rules.trouble)
    } catch (_: OutOfMemoryError) {
        FindingList(trouble = "There is not enough memory to run the rules over this log; close other logs and run them again.")
    }
}
