package badlog.report

import badlog.core.recording.NumberSink
import badlog.core.recording.NumberSinks
import badlog.signals.vocabulary.SignalVocabulary

/**
 * Drops the numbers of topics that no expression can name, so that a question needs no memory for them. It keeps too much rather than too
 * little: possible signals, the x axis, and each topic if the last part of its path occurs in the expressions, regardless of case.
 *
 * @param expressions questions, and definitions of virtual topics.
 * @param xTopic the topic to use as x axis; null for the log's own.
 * @param signals the signals that the expressions name, and the signals that show when the robot was enabled.
 */
class NamedTopics(
    expressions: List<String>,
    private val xTopic: String? = null,
    private val signals: SignalVocabulary = SignalVocabulary.NONE,
) : NumberSinks {
    private val text = expressions.joinToString("\n", transform = ::folded)

    // The patterns of “by topic”.
    private val patterns = Regex("\"([^\"]*\\*[^\"]*)\"").findAll(text).map { found ->
        Regex(found.groupValues[1].split('*').joinToString(".*") { Regex.escape(it).replace("?", "\\E.\\Q") })
    }.toList()

    override fun of(name: String, attributes: List<String>): NumberSink? = if (isNeeded(name, attributes)) null else NumberSink.NONE

    private fun isNeeded(name: String, attributes: List<String>): Boolean =
        isNamed(name) || signals.mayBe(name) || attributes.any { it.contains(X_AXIS, ignoreCase = true) } ||
            name.equals(xTopic, ignoreCase = true)

    /** Checks the last part of its path, which every spelling contains; a quote in it would be doubled. */
    private fun isNamed(name: String): Boolean {
        val end = name.substring(name.lastIndexOf('/', name.length - 2) + 1)
        return folded(end) in text || end.any { it in QUOTES } || patterns.any { it.containsMatchIn(folded(name)) }
    }

    private companion object {
        const val X_AXIS = "xaxis"
        const val QUOTES = "\"`'"

        // Character by character, as expressions compare names.
        fun folded(text: String) = String(CharArray(text.length) { text[it].lowercaseChar() })
    }
}
