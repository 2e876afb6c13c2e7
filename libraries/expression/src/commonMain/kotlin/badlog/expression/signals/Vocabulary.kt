package badlog.expression.signals

import badlog.core.text.isLetterOrDigit

/**
 * The names that expressions over one recording may use. Equal vocabularies have equal signals in the same order, so that an expression
 * parsed for one recording can be used for all recordings with an equal vocabulary.
 *
 * A signal is named by its full name, or by the end of its path if only one signal ends like that: `Battery Voltage` for
 * `System/Battery Voltage`. Case matters only if two names differ in nothing else.
 *
 * @property signals the signals; of two with the same name, the first counts.
 * @property hasTime whether x is a time; if not, an expression with a time, such as `0.5 s`, is a mistake.
 * @property meanings names that mean the same in every recording, whatever the names of its topics. A virtual topic may have such a
 *   name, and then takes precedence; one that is not among [signals] means nothing in this recording.
 * @property thing the word for a signal in messages.
 * @property several names that mean several signals in this recording, at least two; they cannot refer to one of them alone.
 */
class Vocabulary(
    val signals: List<Signal>,
    val hasTime: Boolean,
    val meanings: Set<String> = emptySet(),
    val thing: String = "topic",
    val several: Map<String, List<String>> = emptyMap(),
) {
    /** Creates the vocabulary of a recording over time. */
    constructor(signals: List<Signal>) : this(signals, hasTime = true)

    private val byWords by lazy { signals.groupBy { wordsOf(it.name.substringAfterLast('/')) } }
    private val entries by lazy { Entries(signals) }

    override fun equals(other: Any?): Boolean = this === other ||
        (other is Vocabulary && hasTime == other.hasTime && signals == other.signals && meanings == other.meanings)

    override fun hashCode(): Int = signals.hashCode()

    /** Returns these names with [topic], which takes precedence over a meaning of the same name. */
    fun with(topic: Signal): Vocabulary =
        Vocabulary(signals.filter { it.name != topic.name } + topic, hasTime, meanings - topic.name, thing, several - topic.name)

    /** Returns whether [name] means one of the signals, or several. */
    fun knows(name: String): Boolean = find(name).isNotEmpty()

    /** Returns the signals that [name] may mean: none, one, or several if it is ambiguous. */
    internal fun find(name: String): List<Signal> = entries.find(name, ignoreCase = true)

    /**
     * Returns the signals that have exactly the words of [name] at the end of their paths. The words may be in any order and joined in any
     * way: `voltage of the battery` for `/SystemStats/BatteryVoltage`.
     */
    internal fun withWordsOf(name: String): List<Signal> {
        val wanted = wordsOf(name)
        return if (wanted.size < 2) emptyList() else byWords[wanted].orEmpty()
    }

    /** Returns the length of the longest name at [from] in [text] that ends at a word boundary. Returns 0 if there is none. */
    internal fun longestAt(text: String, from: Int, ignoreCase: Boolean): Int = entries.lengths.firstOrNull { length ->
        val until = from + length
        until <= text.length && isWordEnd(text, until) && entries.find(text.substring(from, until), ignoreCase).isNotEmpty()
    } ?: 0

    /** Returns the one of [meanings] that equals [name], regardless of case, if the recording lacks it; otherwise null. */
    internal fun missingMeaning(name: String): String? =
        meanings.find { it.equals(name, ignoreCase = true) }?.takeIf { meaning -> signals.none { it.name == meaning } }

    /** Returns the signal with the name most similar to [name]; null if none is similar. */
    internal fun nearest(name: String): Signal? = nearestOf(signals, name)

    /** Returns the topic with the name most similar to [name]; null if none is similar. */
    internal fun nearestTopic(name: String): Signal? = nearestOf(signals.filter { it.name !in meanings }, name)

    /**
     * Returns the one of [meanings] in this recording that [name] may stand for. It is similar, or all of its words are in [name]. Null if
     * there is none.
     */
    internal fun nearestMeaning(name: String): Signal? {
        val known = signals.filter { it.name in meanings }
        val words = wordsOf(name)
        return nearestOf(known, name) ?: known.filter { words.containsAll(wordsOf(it.name)) }.maxByOrNull { it.name.length }
    }

    /** The signals of each name. Created on first use, because most vocabularies are only compared. */
    private class Entries(signals: List<Signal>) {
        private val full = HashMap<String, Signal>()
        private val ends = HashMap<String, MutableList<Signal>>()
        private val foldedFull = HashMap<String, MutableList<Signal>>()
        private val foldedEnds = HashMap<String, MutableList<Signal>>()

        init {
            for (signal in signals) {
                if (signal.name.isEmpty() || signal.name in full) continue
                full[signal.name] = signal
                foldedFull.getOrPut(folded(signal.name)) { ArrayList(1) } += signal
                addEnds(signal)
            }
        }

        private fun addEnds(signal: Signal) {
            var slash = signal.name.lastIndexOf('/', signal.name.length - 2)
            var left = MAX_ENDS
            // A name longer than an expression is never looked up.
            while (slash >= 0 && left-- > 0 && signal.name.length - slash <= MAX_EXPRESSION_LENGTH) {
                val end = signal.name.substring(slash + 1)
                ends.getOrPut(end) { ArrayList(1) } += signal
                foldedEnds.getOrPut(folded(end)) { ArrayList(1) } += signal
                slash = if (slash == 0) -1 else signal.name.lastIndexOf('/', slash - 1)
            }
        }

        /** The lengths of all names, the longest first. */
        val lengths: List<Int> = (full.keys + ends.keys).mapTo(HashSet()) { it.length }.sortedDescending()

        fun find(name: String, ignoreCase: Boolean): List<Signal> {
            full[name]?.let { return listOf(it) }
            ends[name]?.let { return it }
            if (!ignoreCase) return emptyList()
            val key = folded(name)
            return foldedFull[key] ?: foldedEnds[key] ?: emptyList()
        }
    }
}

/** The maximum number of characters in an expression. */
internal const val MAX_EXPRESSION_LENGTH = 4000

/** Returns whether a name that ends before [at] ends at a word boundary: `Arm` does not end within `Arms`. */
internal fun isWordEnd(text: String, at: Int): Boolean =
    at >= text.length || at == 0 || !isWordCharacter(text[at]) || !isWordCharacter(text[at - 1])

internal fun isWordCharacter(character: Char): Boolean = isLetterOrDigit(character) || character == '_'

/**
 * Returns the one of [signals] with the name most similar to [name]. Names are compared as written, and by their words in any order. Null
 * if none is similar.
 */
private fun nearestOf(signals: List<Signal>, name: String): Signal? {
    val shown = name.take(MAX_COMPARED)
    val wanted = folded(shown)
    val words = inOrder(shown.substringAfterLast('/')).takeIf { ' ' in it }
    var best: Signal? = null
    var least = maxOf(1, wanted.length / 3) + 1
    for (signal in signals) {
        val end = signal.name.trimEnd('/').substringAfterLast('/').take(MAX_COMPARED)
        val distances = listOfNotNull(
            editDistance(wanted, folded(signal.name.take(MAX_COMPARED)), least),
            editDistance(wanted, folded(end), least),
            words?.let { editDistance(it, inOrder(end), least) },
        )
        val distance = distances.min()
        if (distance < least) {
            least = distance
            best = signal
        }
    }
    return best
}

/** Returns the words of [name] in alphabetical order: `battery voltage` for `BatteryVoltage`. */
private fun inOrder(name: String) = wordsOf(name).sorted().joinToString(" ")

private const val MAX_COMPARED = 80

private fun wordsOf(name: String): Set<String> {
    val words = HashSet<String>()
    var start = 0
    for (at in 1..name.length) {
        val isEnd = at == name.length || !isLetterOrDigit(name[at]) || !isLetterOrDigit(name[at - 1])
        if (!isEnd && (!isCapital(name[at]) || isCapital(name[at - 1]))) continue
        val word = folded(name.substring(start, at)).trim { !isLetterOrDigit(it) }
        if (word.isNotEmpty() && word !in FILLERS) words += word
        start = at
    }
    return words
}

private fun isCapital(character: Char) = character.lowercaseChar() != character

private val FILLERS = setOf("of", "the", "a", "an", "in", "for")

// Character by character, so that the length stays the same.
private fun folded(text: String): String {
    val characters = CharArray(text.length) { text[it].lowercaseChar() }
    return characters.concatToString()
}

/** Returns the number of characters to insert, delete or replace to turn [one] into [other], at most [limit] (Levenshtein 1966). */
internal fun editDistance(one: String, other: String, limit: Int): Int {
    if (kotlin.math.abs(one.length - other.length) >= limit) return limit
    var last = IntArray(other.length + 1) { it }
    var row = IntArray(other.length + 1)
    for (i in one.indices) {
        row[0] = i + 1
        for (j in other.indices) {
            val replaced = last[j] + if (one[i] == other[j]) 0 else 1
            row[j + 1] = minOf(replaced, last[j + 1] + 1, row[j] + 1)
        }
        last = row.also { row = last }
    }
    return minOf(last[other.length], limit)
}

// The maximum number of ends of a path. Names come from files, and all ends of a long one would fill the memory.
private const val MAX_ENDS = 32
