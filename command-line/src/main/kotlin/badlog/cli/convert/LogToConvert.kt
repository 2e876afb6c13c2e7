package badlog.cli.convert

import badlog.catalog.match.MatchMaker
import badlog.cli.input.Failure
import badlog.cli.input.FileName
import badlog.cli.input.LogInput
import badlog.cli.input.readLog
import badlog.cli.search.signalsBeside
import badlog.cli.topic.TopicChoice
import badlog.core.analysis.LogView
import badlog.core.recording.Recording
import badlog.files.terminal.Progress
import badlog.signals.withVirtualTopics
import kotlin.io.path.nameWithoutExtension

/**
 * The log of [input], read for writing in another format.
 *
 * @param virtualTopics definitions of topics to add.
 * @param only the selected topics.
 * @param needed further topics to keep.
 * @throws Failure if it has no topics, or none of the selected ones.
 */
internal class LogToConvert(
    input: LogInput,
    virtualTopics: List<String>,
    only: TopicChoice,
    needed: List<String> = emptyList(),
    progress: Progress,
) {
    private val read: Recording = readLog(input.file, progress, maker = MatchMaker)

    /** Whether its file combines the logs of a match. */
    val isMatch: Boolean = MatchMaker.isSource(input.file)

    /** The name of its file; for a match, without the ending of a ZIP or `match.json`. */
    val name: FileName = FileName.of(if (isMatch) input.file.resolveSibling(input.file.nameWithoutExtension) else input.file)

    init {
        if (read.topics.isEmpty()) {
            throw Failure("${input.file}: nothing can be converted. ${read.problems.firstOrNull()?.message.orEmpty()}".trim())
        }
    }

    /** The log with the added topics, and the errors of topics that could not be added. */
    val all = LogView.of(read).withVirtualTopics(virtualTopics, signalsBeside(input.file))

    /** The names of the topics that were added. */
    val added: Set<String> = all.view.recording.topics.drop(read.topics.size).mapTo(HashSet()) { it.name }

    /** The part of it with the selected topics. */
    val wanted: Recording = only.of(all.view, input.file, needed)
}
