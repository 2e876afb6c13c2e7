package badlog.cli.topic

import badlog.cli.input.Failure
import badlog.core.analysis.LogView
import badlog.core.recording.Recording
import badlog.signals.vocabulary.NamePattern
import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.help
import com.github.ajalt.clikt.parameters.options.multiple
import com.github.ajalt.clikt.parameters.options.option
import java.nio.file.Path

/**
 * A selection of topics.
 *
 * @property patterns the patterns for the names of selected topics; if there are none, all topics are selected.
 */
internal class TopicChoice(val patterns: List<NamePattern>) {
    /** The patterns for people. */
    val text: String get() = patterns.joinToString(" or ") { "“${it.text}”" }

    /** Whether all topics are selected. */
    val isAll: Boolean get() = patterns.isEmpty()

    /** Returns whether the topic called [name] is selected. */
    operator fun contains(name: String): Boolean = isAll || patterns.any { it.matches(name) }

    /**
     * Returns [view], which was read from [file], with only the selected topics, its x axis, and the topics
     * [needed].
     *
     * @throws Failure if it has none of them.
     */
    fun of(view: LogView, file: Path, needed: List<String> = emptyList()): Recording {
        val recording = view.recording
        if (isAll) return recording
        if (recording.topics.none { it.name in this }) {
            throw Failure(
                "$file has no topic that matches $text; “badlog info --topics” lists its topics.",
            )
        }
        return recording.copy(topics = recording.topics.filter { it.name in this || it === view.xAxis.topic || it.name in needed })
    }
}

/** `--only`, for all commands that list or write topics. */
internal class OnlyOption : OptionGroup() {
    private val patterns by option("--only", metavar = "PATTERN").multiple()
        .help("Only topics with such a name: 'PDP/*'; may be repeated.")

    val choice: TopicChoice get() = TopicChoice(patterns.map(::NamePattern))
}
