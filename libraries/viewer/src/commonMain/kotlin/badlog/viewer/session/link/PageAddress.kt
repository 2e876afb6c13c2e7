package badlog.viewer.session.link

import badlog.core.analysis.Span
import badlog.rules.Finding
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardException
import badlog.viewer.choices.board.boardOfText
import badlog.viewer.choices.board.spanOfText
import badlog.viewer.choices.board.spanText
import badlog.viewer.choices.board.toText
import badlog.viewer.session.video.VideoAlignment
import badlog.viewer.state.Action
import badlog.viewer.state.FindingAction
import badlog.viewer.state.Place
import badlog.viewer.state.PlaceAction
import badlog.viewer.state.WantedFinding
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

/**
 * The parts of a page that a reader has opened.
 *
 * @property search the text in the search box; may be empty.
 * @property hasValues whether the values at the cursor are open.
 * @property hasModules whether the modules of a swerve drive are open.
 * @property statistics the places on the board, from 1, of the graphs with open statistics.
 */
data class OpenedParts(
    val search: String = "",
    val hasValues: Boolean = false,
    val hasModules: Boolean = false,
    val statistics: List<Int> = emptyList(),
) {
    /** Returns everything except [search] for an address: `values;1;3` or `modules;1`. */
    internal fun toText(): String {
        val panels = listOfNotNull(VALUES.takeIf { hasValues }, MODULES.takeIf { hasModules })
        return (panels + statistics).joinToString(";")
    }
}

/** Returns the opened parts of [text], as [OpenedParts.toText] writes it, with [search]. Parts of a newer badlog are ignored. */
internal fun openedPartsOf(text: String, search: String): OpenedParts {
    val parts = text.split(';')
    val statistics = parts.mapNotNull(String::toIntOrNull).filter { it > 0 }.distinct()
    return OpenedParts(search, VALUES in parts, MODULES in parts, statistics)
}

private const val VALUES = "values"
private const val MODULES = "modules"

/**
 * The pinned cursors and the selected finding, each as the end of an address. They are restored when the log is opened again; may be empty.
 */
val Place.keptText: String
    get() {
        val selected = visited?.run { WantedFinding(finding.rule, finding.topic, span.from) } ?: wanted
        val finding = selected?.run { PageAddress(x, finding = FindingName(rule, topic)) } ?: PageAddress()
        val cursors = PageAddress(cursors.pinned, second = cursors.second)
        return listOf(cursors, finding).joinToString(" ") { it.toText() }.trim()
    }

/** Returns the actions that lead back to the place of [text], which [keptText] wrote. */
fun actionsOfKept(text: String): List<Action> = text.split(' ').mapNotNull { part ->
    val address = pageAddressOf(part)
    val x = address.moment ?: return@mapNotNull null
    address.finding?.run { FindingAction.Select(WantedFinding(rule, topic, x)) } ?: PlaceAction.Pin(x, address.second)
}

/**
 * The name that distinguishes a finding from others that begin at the same moment.
 *
 * @property rule the name of the rule or the hook that found it.
 * @property topic the topic of the finding; null if there is none.
 */
class FindingName(val rule: String, val topic: String?) {
    /** Returns whether this is the name of [finding]. */
    fun isOf(finding: Finding): Boolean = finding.rule == rule && finding.topic == topic

    /** Returns the name for an address: `Brownout;PDP/Voltage`. */
    internal fun toText(): String = listOfNotNull(rule, topic).joinToString(";", transform = ::addressText)

    companion object {
        /** Returns the name of [finding]. */
        fun of(finding: Finding): FindingName = FindingName(finding.rule, finding.topic)
    }
}

/** Returns the name that [FindingName.toText] wrote as [text]; null for any other text. */
internal fun findingNameOf(text: String): FindingName? {
    val names = text.split(';').map { nameOfAddress(it) ?: return null }
    return if (names.size > 2) null else FindingName(names[0], names.getOrNull(1))
}
