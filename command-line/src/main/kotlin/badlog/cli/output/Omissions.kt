package badlog.cli.output

import badlog.cli.text.counted
import badlog.cli.text.grouped
import badlog.cli.text.wrapped
import badlog.formats.wpilog.Omission

/**
 * The differences of a written file from its source.
 *
 * @param things the missing content, each as a short text such as `38 units`.
 * @param omissions the content that a WPILOG cannot express.
 * @param remarks other missing content, each as a sentence without its end.
 * @property hasLoss whether samples are missing although all were requested.
 */
internal class Omissions(
    private val things: List<String> = emptyList(),
    private val omissions: List<Omission> = emptyList(),
    private val remarks: List<String> = emptyList(),
    val hasLoss: Boolean = false,
) {
    /** The text after the count of the written content. */
    val tail: String get() = if (things.isEmpty()) "" else "; the file cannot hold ${things.joinToString()}"

    /** The lines below the [tail]: one or more for each kind of difference, for all topics together. */
    val lines: List<String>
        get() = remarks.map { wrapped("  ", it, indent = INDENT) } + omissions.groupBy { it.what }.map { (what, alike) ->
            wrapped("  differs: ", what.removeSuffix(".") + placeOf(alike) + ".", indent = INDENT)
        }

    /** All differences, each as a sentence or a short phrase. */
    val all: List<String>
        get() = remarks + things + omissions.map { omission ->
            val topic = omission.topic?.let { "“$it”: " }.orEmpty()
            topic + omission.what.removeSuffix(".") + (if (omission.count > 1) " (${grouped(omission.count.toLong())})" else "") + "."
        }

    operator fun plus(other: Omissions) =
        Omissions(things + other.things, omissions + other.omissions, remarks + other.remarks, hasLoss || other.hasLoss)

    private fun placeOf(alike: List<Omission>): String {
        val count = alike.sumOf { it.count.toLong() }
        val topics = alike.mapNotNull { it.topic }.distinct()
        return when {
            topics.size > 1 -> " (${grouped(count)} in ${counted(topics.size.toLong(), "topic")})"
            topics.size == 1 -> " (${grouped(count)} in “${topics[0]}”)"
            count > 1 -> " (${grouped(count)})"
            else -> ""
        }
    }

    companion object {
        private const val INDENT = 4

        /** Returns [count] with [noun], as a missing thing; null for 0. */
        fun thing(count: Int, noun: String): String? = if (count == 0) null else counted(count.toLong(), noun)
    }
}
