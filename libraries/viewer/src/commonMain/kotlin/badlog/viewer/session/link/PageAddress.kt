package badlog.viewer.session.link

import badlog.core.analysis.Span
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardException
import badlog.viewer.choices.board.boardOfText
import badlog.viewer.choices.board.spanOfText
import badlog.viewer.choices.board.spanText
import badlog.viewer.choices.board.toText
import badlog.viewer.session.video.VideoAlignment
import badlog.viewer.text.addressText
import badlog.viewer.text.decimalsFor
import badlog.viewer.text.fixedText
import badlog.viewer.text.nameOfAddress

/**
 * The content of a page's address after its `#`:
 * `#t=93.7&b=95.2&finding=Brownout;Voltage&x=90:100&board=Voltage;Mode&f=Power+~003d+Voltage*Current&q=battery&open=values;1`.
 *
 * @property moment the new x of the cursor, in the unit of the x axis; null if it is not moved.
 * @property second the new x of the second cursor, if there is a [moment]; null if there is none.
 * @property finding the finding to show at [moment]; null for the worst one there.
 * @property visible the part of x to show; null for a range around the moment.
 * @property board the graphs to show together, by the names of their lines; null for the existing ones.
 * @property opened the search and the other opened parts.
 * @property formulas the definitions of calculated topics, in addition to the page's own.
 * @property problems a sentence for each damaged part, which is ignored.
 * @property video the alignment of the video that the reader opens or the page has: `v=-3.5` if it begins 3.5 s before x is 0.
 */
class PageAddress(
    val moment: Double? = null,
    val visible: Span? = null,
    val board: Board? = null,
    val formulas: List<String> = emptyList(),
    val problems: List<String> = emptyList(),
    val finding: FindingName? = null,
    val video: VideoAlignment? = null,
    val second: Double? = null,
    val opened: OpenedParts = OpenedParts(),
) {
    /** Whether the address has no content. */
    val isEmpty: Boolean get() =
        moment == null && visible == null && board == null && formulas.isEmpty() && video == null && opened == OpenedParts()

    /**
     * Returns the same content for a link that is short enough to read. Positions of more than 12 characters, as pointers set them, keep
     * only the decimals that are visible while the screen shows [width] of x. Shorter times, as in logs, and the moment of a finding stay
     * as they are.
     */
    fun seenIn(width: Double): PageAddress {
        val decimals = decimalsFor(width)
        fun seen(x: Double) = if (x.toString().length <= TIME_LENGTH) x else fixedText(x, decimals).toDouble()
        return PageAddress(
            moment = if (finding == null) moment?.let(::seen) else moment,
            visible = visible?.run { Span(seen(from), seen(to)) },
            board, formulas, problems, finding, video, second?.let(::seen), opened,
        )
    }

    /** Returns the end of the address, from the `#` on; empty without content. */
    fun toText(): String {
        val parts = listOfNotNull(
            moment?.takeIf { it.isFinite() }?.let { "t=" + numberText(it) },
            second?.takeIf { moment?.isFinite() == true && it.isFinite() }?.let { "b=" + numberText(it) },
            finding?.takeIf { moment?.isFinite() == true }?.let { "finding=" + it.toText() },
            visible?.takeIf { it.from < it.to && it.from.isFinite() && it.to.isFinite() }?.let { "x=" + spanText(it) },
            board?.let { "board=" + it.toText() },
            formulas.takeIf { it.isNotEmpty() }?.joinToString(";", "f=", transform = ::addressText),
            video?.let { "v=" + numberText(it.startSeconds) },
            opened.search.takeIf { it.isNotEmpty() }?.let { "q=" + addressText(it) },
            opened.toText().takeIf { it.isNotEmpty() }?.let { "open=$it" },
        )
        return if (parts.isEmpty()) "" else parts.joinToString("&", "#")
    }
}

/**
 * Returns the content of [text], the end of an address from the `#` on. Unknown parts, such as anchors on the page or additions of a
 * newer badlog, are ignored silently. A link of a later version than [LINK_VERSION] is reported, because its parts may have another
 * meaning.
 */
fun pageAddressOf(text: String): PageAddress {
    val problems = ArrayList<String>()
    // Programs that forward links may percent-encode any character, although none of these needs it.
    val parts = withoutPercents(text.removePrefix("#")).split('&').filter { '=' in it }
        .associate { it.substringBefore('=') to it.substringAfter('=') }

    val version = parts["version"]?.toIntOrNull() ?: LINK_VERSION
    if (version > LINK_VERSION) problems += "This link is from a newer badlog; export the log with that one to see all that it shows."

    fun <T : Any> read(key: String, what: String, read: (String) -> T?): T? {
        val part = parts[key] ?: return null
        val value = read(part)
        if (value == null) problems += "This link’s $what is damaged; copy the link again."
        return value
    }
    return PageAddress(
        moment = read("t", "time") { it.toDoubleOrNull()?.takeIf(Double::isFinite) },
        visible = read("x", "range", ::spanOfText),
        board = read("board", "board", ::boardOrNull),
        formulas = read("f", "formula", ::formulasOrNull).orEmpty(),
        problems = problems,
        finding = read("finding", "finding", ::findingNameOf),
        video = read("v", "video’s place") { text -> text.toDoubleOrNull()?.takeIf(Double::isFinite)?.let(::VideoAlignment) },
        second = read("b", "second cursor") { it.toDoubleOrNull()?.takeIf(Double::isFinite) },
        opened = openedPartsOf(parts["open"].orEmpty(), read("q", "search", ::nameOfAddress).orEmpty()),
    )
}

private fun numberText(number: Double) = "$number".replace("+", "").removeSuffix(".0")

private fun boardOrNull(text: String): Board? = try {
    boardOfText(text)
} catch (_: BoardException) {
    null
}

private fun formulasOrNull(text: String): List<String>? {
    val read = text.split(';').filter { it.isNotEmpty() }.map(::nameOfAddress)
    return if (null in read) null else read.filterNotNull().distinct()
}

// Decodes only single-byte characters: others are never written here.
private fun withoutPercents(text: String): String {
    val parts = text.split('%')
    return parts.drop(1).joinToString("", parts[0]) { part ->
        val code = part.take(DIGITS).takeIf { it.length == DIGITS }?.toIntOrNull(HEXADECIMAL)?.takeIf { it in 0..LAST_ASCII }
        if (code == null) "%$part" else code.toChar() + part.drop(DIGITS)
    }
}

/** The version that this program writes, without naming it to keep links short. It is also the version of links that do not name one. */
private const val LINK_VERSION = 1

/** The length of a time with microseconds, in a log that is not too long for a battery: `12345.678901`. */
private const val TIME_LENGTH = 12

private const val HEXADECIMAL = 16
private const val DIGITS = 2
private const val LAST_ASCII = 0x7f
