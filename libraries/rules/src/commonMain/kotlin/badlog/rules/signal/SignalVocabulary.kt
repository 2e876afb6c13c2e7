package badlog.rules.signal

import badlog.analysis.FlagReading
import badlog.expression.signals.SignalKind

/** What signals are called in the logs of robots; `docs/signals.md` has the format of the file that it is read from. */
public class SignalVocabulary internal constructor(
    internal val signals: List<SignalName>,
    internal val units: List<NamedUnit>,
    internal val linked: List<List<NamePattern>>,
) {
    private val byName = signals.associateBy { it.name }

    /** Whether it names no signal. */
    public val isEmpty: Boolean get() = signals.isEmpty()

    internal fun find(name: String): SignalName? = byName[name]

    /**
     * The signals that [text] holds the names of, in any case of letters, those that they are the sums of, and those that tell the match
     * and when the robot was enabled.
     */
    public fun namedIn(text: String): SignalVocabulary {
        val named = signals.filter { it.name in OF_EVERY_LOG || text.contains(it.name, ignoreCase = true) }
        return SignalVocabulary(named + named.mapNotNull { it.sumOf?.let(::find) }, units, linked)
    }

    /** Whether a topic called [name] may be one of the signals. */
    public fun mayBe(name: String): Boolean = NamePattern.folded(name).let { folded ->
        signals.any { signal -> signal.topics.any { it.pattern.matchesFolded(folded) } }
    }

    /** The unit that [name] tells by its end; the longest that fits counts, as in “RadPerSec”. Null for none. */
    internal fun unitIn(name: String): NamedUnit? = units.filter { it.isOf(name) }.maxByOrNull { it.ending.length }

    /** This and what [own], a team's vocabulary, adds: its topics come before others, and what it excepts counts, too. */
    public fun with(own: SignalVocabulary): SignalVocabulary {
        if (own === NONE) return this
        val extended = signals.map { signal -> own.find(signal.name)?.let(signal::with) ?: signal }
        return SignalVocabulary(extended + own.signals.filter { find(it.name) == null }, own.units + units, own.linked + linked)
    }

    public companion object {
        /** No signals. */
        public val NONE: SignalVocabulary = SignalVocabulary(emptyList(), emptyList(), emptyList())
    }
}

/** The [unit] that the name of a topic tells by ending in [ending]. */
internal class NamedUnit(val ending: String, val unit: String) {
    fun isOf(name: String): Boolean {
        val end = if (name.endsWith(']')) name.substringBeforeLast('[') else name
        if (!end.endsWith(ending, ignoreCase = true)) return false
        val before = end.getOrNull(end.length - ending.length - 1) ?: return true
        // “Full Cycle MS” and “FullCycleMS” end in MS; “Items” does not.
        return before in " _-/." || (end.endsWith(ending) && isUpper(ending[0]) && !isUpper(before))
    }
}

// The standard library's own would carry tables of letters into every page.
private fun isUpper(char: Char) = char.lowercaseChar() != char

/**
 * A pattern for the topics of a signal.
 *
 * @property unit the unit of what it fits, where neither the log nor the name says one; null where that is the signal's. Of a condition,
 *   how such a topic says that it is so, as [flagReadingOf] has it.
 */
internal class TopicPattern(val pattern: NamePattern, val unit: String?) {
    /** Of a condition: how what it fits says that it is so. */
    val reading: FlagReading get() = unit?.let(::flagReadingOf) ?: FlagReading.Truth

    /** Whether a topic of the kind [kind] can be a signal of [content] as this pattern has it. */
    fun fits(kind: SignalKind, content: SignalContent): Boolean =
        if (content == SignalContent.CONDITION && reading is FlagReading.Text) SignalContent.TEXT.isOf(kind) else content.isOf(kind)
}

/** How a topic says that a condition holds, written `not`, `bit 3`, `bits 1-2 are 1` or `is TEXT`; null for another [text]. */
internal fun flagReadingOf(text: String): FlagReading? = when {
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

/** Those of whole numbers that samples hold exactly. */
private val BITS = 0..52

/**
 * A signal, and the topics that it may be.
 *
 * @property unit the unit in which rules and questions get it; null for the topic's own.
 * @property isMany whether each topic that fits is one of it; else the first pattern that fits one decides.
 * @property sumOf the signal whose topics, added, are this one where no topic is; or null.
 */
internal class SignalName(
    val name: String,
    val meaning: String,
    val content: SignalContent,
    val unit: String?,
    val topics: List<TopicPattern>,
    val except: List<NamePattern>,
    val isMany: Boolean,
    val sumOf: String?,
) {
    fun with(own: SignalName) = SignalName(name, meaning, content, unit, own.topics + topics, own.except + except, isMany, sumOf)
}

/** What the samples of a signal are. */
internal enum class SignalContent(private vararg val kinds: SignalKind) {
    NUMBER(SignalKind.NUMBER),
    CONDITION(SignalKind.NUMBER, SignalKind.CONDITION),
    TEXT(SignalKind.STATE, SignalKind.EVENT),
    ;

    /** What an expression takes one for that is missing. */
    val usualKind: SignalKind get() = kinds.last()

    fun isOf(kind: SignalKind): Boolean = kind in kinds
}
