package badlog.signals.vocabulary

import badlog.core.analysis.FlagReading
import badlog.expression.signals.SignalKind

/** The names of signals in robots' logs; `docs/signals.md` describes the format of its file. */
class SignalVocabulary(val signals: List<SignalName>, internal val units: List<NamedUnit>, val linked: List<List<NamePattern>>) {
    private val byName = signals.associateBy { it.name }

    /** Whether it names no signal. */
    val isEmpty: Boolean get() = signals.isEmpty()

    fun find(name: String): SignalName? = byName[name]

    /**
     * Returns the signals for which [text] contains every word of the name, regardless of case. Also returns the signals that they add up,
     * and those needed for every log, such as match, mode and battery.
     */
    fun namedIn(text: String): SignalVocabulary {
        val named = signals.filter { it.name in OF_EVERY_LOG || it.name.split(' ').all { word -> text.contains(word, ignoreCase = true) } }
        return SignalVocabulary(named + named.mapNotNull { it.sumOf?.let(::find) }, units, linked)
    }

    /** Returns whether a topic called [name] may be one of the signals. */
    fun mayBe(name: String): Boolean = setOf(name, withoutUnit(name)).map(NamePattern::folded).any { folded ->
        signals.any { signal -> signal.topics.any { it.pattern.matchesFolded(folded) } }
    }

    /** Returns [name] without a unit at its end: `Gyro/Yaw` for `Gyro/Yaw (deg)` and `Gyro/YawDeg`. */
    internal fun withoutUnit(name: String): String {
        val unit = unitIn(name)?.takeIf { !name.endsWith(']') } ?: return name
        return name.trimEnd(')').dropLast(unit.ending.length).trimEnd(' ', '_', '-', '.', '(').ifEmpty { name }
    }

    /** Returns the unit at the end of [name]; the longest match counts, as in “RadPerSec”. Null for none. */
    internal fun unitIn(name: String): NamedUnit? = units.filter { it.isOf(name) }.maxByOrNull { it.ending.length }

    /** Returns this vocabulary with [own], a team's vocabulary: its topics come before others, and its exceptions are added. */
    fun with(own: SignalVocabulary): SignalVocabulary {
        if (own === NONE) return this
        val extended = signals.map { signal -> own.find(signal.name)?.let(signal::with) ?: signal }
        return SignalVocabulary(extended + own.signals.filter { find(it.name) == null }, own.units + units, own.linked + linked)
    }

    companion object {
        val NONE: SignalVocabulary = SignalVocabulary(emptyList(), emptyList(), emptyList())
    }
}

/** The [unit] of topics with names that end in [ending]. */
class NamedUnit(val ending: String, val unit: String) {
    fun isOf(name: String): Boolean {
        // “Height (m)” has its unit in parentheses.
        val end = if (name.endsWith(']')) name.substringBeforeLast('[') else name.removeSuffix(")")
        if (!end.endsWith(ending, ignoreCase = true)) return false
        // “Encoder A” is not a current.
        if (ending.length == 1 && !name.endsWith(")")) return false
        val before = end.getOrNull(end.length - ending.length - 1) ?: return true
        // “Full Cycle MS” and “FullCycleMS” end in MS; “Items” does not.
        return before in " _-/.(" || (end.endsWith(ending) && isUpper(ending[0]) && !isUpper(before))
    }
}

// The standard library's function would add tables of letters to every page.
private fun isUpper(char: Char) = char.lowercaseChar() != char

/**
 * A pattern for the topics of a signal.
 *
 * @property unit the unit of matching topics if neither the log nor the name has one; null for the signal's own. For a condition, how
 *   such a topic is read, see [flagReadingOf].
 */
class TopicPattern(val pattern: NamePattern, val unit: String?) {
    /** For a condition: how matching topics are read. */
    val reading: FlagReading get() = unit?.let(::flagReadingOf) ?: FlagReading.Truth

    /** Returns whether a topic of the kind [kind] can be a signal of [content] by this pattern. */
    fun fits(kind: SignalKind, content: SignalContent): Boolean =
        if (content == SignalContent.CONDITION && reading is FlagReading.Text) SignalContent.TEXT.isOf(kind) else content.isOf(kind)
}

/** Returns how a topic is read as a condition, written `not`, `bit 3`, `bits 1-2 are 1` or `is TEXT`. Null for any other [text]. */
fun flagReadingOf(text: String): FlagReading? = when {
    text == "not" -> FlagReading.Opposite
    text.startsWith("bits ") -> bitsIn(text)
    text.startsWith("bit ") -> text.substring(4).toIntOrNull()?.takeIf { it in BITS }?.let { FlagReading.Bits(it, it, 1) }
    text.startsWith("is ") && text.length > 3 -> FlagReading.Text(text.substring(3).trim())
    else -> null
}

private fun bitsIn(text: String): FlagReading? {
    val words = text.split(' ', '-')
    if (words.size != 5 || words[3] != "are") return null
    val first = words[1].toIntOrNull()?.takeIf { it in BITS } ?: return null
    val last = words[2].toIntOrNull()?.takeIf { it in BITS && it >= first } ?: return null
    return words[4].toLongOrNull()?.let { FlagReading.Bits(first, last, it) }
}

/** The bits of whole numbers that samples hold exactly. */
private val BITS = 0..52

/**
 * A signal, and the topics that it may be.
 *
 * @property unit its unit in rules and questions; null for the topic's own.
 * @property isMany whether every matching topic is the signal; otherwise the first pattern that matches a topic decides.
 * @property atMost the largest possible number, in [unit]; larger ones are not readings. Null if there is no limit.
 * @property sumOf the signal with the topics that add up to this one, if it has no topic itself; or null.
 */
class SignalName(
    val name: String,
    val meaning: String,
    val content: SignalContent,
    val unit: String?,
    val topics: List<TopicPattern>,
    val except: List<NamePattern>,
    val isMany: Boolean,
    val sumOf: String?,
    val atMost: Double? = null,
) {
    fun with(own: SignalName) = SignalName(name, meaning, content, unit, own.topics + topics, own.except + except, isMany, sumOf, atMost)
}

/** The kind of content of a signal's samples. */
enum class SignalContent(private vararg val kinds: SignalKind) {
    NUMBER(SignalKind.NUMBER),
    CONDITION(SignalKind.NUMBER, SignalKind.CONDITION),
    TEXT(SignalKind.STATE, SignalKind.EVENT),
    ;

    /** The kind that an expression assumes for a missing signal. */
    val usualKind: SignalKind get() = kinds.last()

    fun isOf(kind: SignalKind): Boolean = kind in kinds
}
