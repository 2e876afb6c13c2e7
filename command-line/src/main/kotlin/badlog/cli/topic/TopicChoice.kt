package badlog.cli.topic

import badlog.analysis.LogView
import badlog.cli.input.Failure
import badlog.recording.Recording
import badlog.rules.signal.NamePattern
import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.help
import com.github.ajalt.clikt.parameters.options.multiple
import com.github.ajalt.clikt.parameters.options.option
import java.nio.file.Path

/**
 * Which topics are wanted.
 *
 * @property patterns one of these fits the name of each of them; without any, all topics are wanted.
 */
internal class TopicChoice(val patterns: List<NamePattern>) {
    /** The patterns as a person reads them. */
    val text: String get() = patterns.joinToString(" or ") { "“${it.text}”" }

    /** Whether no topic is left out. */
    val isAll: Boolean get() = patterns.isEmpty()

    /** Whether the topic called [name] is wanted. */
    operator fun contains(name: String): Boolean = isAll || patterns.any { it.matches(name) }

    /**
     * What [view], which was read from [file], has of them, with its x axis and with the topics [needed] besides.
     *
     * @throws Failure when it has none of them.
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

/** `--only`, for everything that lists or writes topics. */
internal class OnlyOption : OptionGroup() {
    private val patterns by option("--only", metavar = "PATTERN").multiple()
        .help("Only topics with such a name: 'PDP/*'; may be repeated.")

    /** What it asks for. */
    val choice: TopicChoice get() = TopicChoice(patterns.map(::NamePattern))
}
