package badlog.rules

import badlog.core.analysis.Series
import badlog.expression.signals.Signals

/**
 * The texts of the state or event topic [name] of [signals] at the places that [question] found.
 *
 * Several messages may share a time, as in a Driver Station log, or a cell, if the log was converted to rows. Then only the messages that
 * the question is about are returned, not the ones that happened to be logged with them.
 */
internal class Messages(private val question: RuleProgram.Question, private val signals: Signals, private val name: String) {
    private val series = signals.series(name)
    private val texts = signals.states(name)
    private val isMatch = HashMap<String, Boolean>()

    // A question that has other topics, too, cannot be evaluated for a text alone.
    private val hasSingleTopic = question.expression.topics.size == 1

    /**
     * Returns the texts logged last at or before [time], without the stack traces of errors. Returns a single empty text if there are none.
     */
    fun at(time: Double): List<String> {
        var last = if (series.isOrdered) series.firstAfter(time) - 1 else series.x.indexOfLast { it <= time }
        while (last >= 0 && series.y[last].isNaN()) last--
        if (last < 0) return listOf("")
        var first = last
        while (first > 0 && series.x[first - 1] == series.x[last]) first--
        val said = (first..last).filter { !series.y[it].isNaN() }.map { texts[series.y[it].toInt()] }
        val asked = if (said.size > 1 && hasSingleTopic) said.filter(::isMatch) else said
        return asked.ifEmpty { said }.map(::shortened).distinct()
    }

    private fun isMatch(text: String) = isMatch.getOrPut(text) {
        val alone = object : Signals by signals {
            override fun series(name: String) = Series(doubleArrayOf(0.0), doubleArrayOf(0.0))

            override fun states(name: String) = listOf(text)
        }
        question.expression.answerIfHolds(alone) != null
    }

    /**
     * Returns [text] without details that can be read in the log, such as a stack trace. It keeps its first line, or more if that is short.
     */
    private fun shortened(text: String): String {
        val part = if (text.length > MAX_LETTERS && hasSingleTopic) text.split(BETWEEN).firstOrNull(::isMatch) ?: text else text
        // AdvantageKit logs the console output of a loop as one text.
        val isConsole = hasSingleTopic && '\n' in part
        val message = if (isConsole) part.lines().run { drop(indexOfFirst(::isMatch).coerceAtLeast(0)) }.joinToString("\n") else part
        var end = message.indexOf('\n')
        while (end in 0 until FEW_LETTERS) end = message.indexOf('\n', end + 1)
        val head = (if (end < 0) message else message.take(end)).trim()
        return if (head.length > MAX_LETTERS) head.take(MAX_LETTERS) + "…" else head
    }
}

/** The separator of messages that share a cell; a message may have it, too. */
private const val BETWEEN = "; "
private const val FEW_LETTERS = 20
private const val MAX_LETTERS = 300
