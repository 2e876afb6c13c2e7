package badlog.expression.syntax

import badlog.expression.signals.Vocabulary
import badlog.expression.signals.editDistance
import badlog.expression.signals.isWordCharacter

/** The words that are keywords in exactly this spelling. */
internal val KEYWORDS = setOf("not", "true", "false", AXIS) + Mode.entries.map { it.word }

/** The meaning of a word where an operand is allowed. */
internal sealed interface Meaning {
    class Topic(val node: Node.Topic) : Meaning

    /** A function call. The scanner is still before [name], which is as written. */
    class Call(val name: String) : Meaning

    /** A keyword. The scanner is still before it. */
    class Keyword(val word: String) : Meaning
}

/** Distinguishes names of topics from functions and keywords. */
internal class NameReader(private val text: String, private val scanner: Scanner, private val vocabulary: Vocabulary) {
    /** Returns the meaning of the text at the scanner's position. */
    fun read(): Meaning {
        val from = afterNeedlessSlash(scanner.at)
        val word = scanner.wordAt(from)
        val key = word.lowercase()
        // A keyword in its usual spelling yields only to a longer name written in exactly the same case.
        val isKeyword = word in KEYWORDS
        val length = vocabulary.longestAt(text, from, ignoreCase = !isKeyword)
        if (isKeyword && length <= word.length) return Meaning.Keyword(word)
        if (from == scanner.at && length <= word.length && Function.called(key).isNotEmpty() && isCalled(from + word.length)) {
            return Meaning.Call(word)
        }
        byWords(from, length)?.let { return it }
        failUnlessComplete(from, length)
        if (length > 0) {
            scanner.at = from + length
            return Meaning.Topic(topic(text.substring(from, scanner.at), from, scanner.at))
        }
        if (key in KEYWORDS) return Meaning.Keyword(key)
        failUnknown(from, word, key)
    }

    /**
     * Returns the topic meant by the words at [from]. The words must be longer than the name of [length] there, and must not be a name
     * themselves.
     */
    private fun byWords(from: Int, length: Int): Meaning.Topic? {
        val until = nameEnd(from)
        if (until <= from + length || isCalled(until)) return null
        val found = vocabulary.withWordsOf(text.substring(from, until)).singleOrNull() ?: return null
        scanner.at = until
        return Meaning.Topic(Node.Topic(from, until, found))
    }

    /**
     * Fails if a name at [from] seems to be longer than the one of [length] there. For example, `battery` is not all of `battery voltge`.
     */
    private fun failUnlessComplete(from: Int, length: Int) {
        val until = nameEnd(from)
        var next = from + length
        while (next < until && text[next] == ' ') next++
        val hasRest = length > 0 && next in from + length + 1 until until
        val goesOn = hasRest && !isCalled(until) && vocabulary.longestAt(text, next, ignoreCase = true) == 0
        val name = text.substring(from, until)
        if (goesOn && near(name).isNotEmpty()) failUnknownTopic(name, from, until)
    }

    // In other tools, names begin with a slash, like paths.
    private fun afterNeedlessSlash(from: Int): Int {
        val isNeedless = text[from] == '/' && vocabulary.longestAt(text, from, ignoreCase = true) == 0
        return if (isNeedless && vocabulary.longestAt(text, from + 1, ignoreCase = true) > 0) from + 1 else from
    }

    /** Returns the topic called [name], which is written from [from] until [until]. */
    fun topic(name: String, from: Int, until: Int): Node.Topic {
        val found = vocabulary.find(name).ifEmpty { vocabulary.find(name.removePrefix("/")) }
        if (found.isEmpty()) failUnknownTopic(name, from, until)
        if (found.size > 1) {
            val some = found.take(MAX_NAMED).joinToString(" or ") { "“${it.name}”" }
            val others = if (found.size > MAX_NAMED) " or ${found.size - MAX_NAMED} others" else ""
            throw Mistake(from, until, ExpressionErrorKind.AMBIGUOUS_TOPIC, "“$name” may mean $some$others.")
        }
        return Node.Topic(from, until, found[0])
    }

    /** Returns whether the word at [from] is a function call. */
    fun isCallAt(from: Int): Boolean = scanner.wordAt(from).let { Function.called(it).isNotEmpty() && isCalled(from + it.length) }

    /** Fails because the text at [from] is written as a path, although parts of it are names. */
    fun failPath(from: Int): Nothing {
        val until = nameEnd(from)
        val name = text.substring(from, until)
        val near = vocabulary.nearest(name) ?: vocabulary.find(name.substringAfterLast('/')).firstOrNull()
        val nearest = if (near == null) "" else " Did you mean “${near.name}”?"
        val divided = name.replaceFirst("/", " / ")
        throw Mistake(
            from,
            until,
            ExpressionErrorKind.UNKNOWN_TOPIC,
            "${unknownNameText(name)}.$nearest To divide, put spaces around the slash: $divided.",
        )
    }

    private fun isCalled(at: Int): Boolean {
        var next = at
        while (next < text.length && text[next].isWhitespace()) next++
        return next < text.length && text[next] == '('
    }

    private fun failUnknown(from: Int, word: String, key: String): Nothing {
        val operator = scanner.peekOperator()?.first ?: if (key == "for") word else null
        when {
            operator != null && !(text[from] == '/' && scanner.wordAt(from + 1).isNotEmpty()) -> {
                val written = text.substring(from, from + operator.length)
                fail(from, from + operator.length, "Something is missing before “$written”.")
            }

            word.isEmpty() && text[from] != '/' -> {
                val found = text[from]
                fail(
                    from,
                    from + 1,
                    if (found in ",)") {
                        "Something is missing before “$found”."
                    } else {
                        "“$found” is not expected here."
                    },
                )
            }

            isCalled(from + word.length) -> {
                val nearest = NAMES_IN_OTHER_TOOLS[key] ?: Function.entries.minBy { editDistance(key, it.title, NO_LIMIT) }.title
                val isNear = key in NAMES_IN_OTHER_TOOLS || editDistance(key, nearest, NO_LIMIT) <= maxOf(1, key.length / 3)
                val suggestion = if (isNear) "; did you mean $nearest?" else "."
                fail(from, from + word.length, "There is no function “$word”$suggestion")
            }

            Function.called(key).isNotEmpty() ->
                fail(from, from + word.length, "$key is a function; put its operands in parentheses after it.")

            else -> {
                val until = nameEnd(from)
                failUnknownTopic(text.substring(from, until), from, until)
            }
        }
    }

    /** Returns where an intended name seems to end. Names have spaces and slashes, but no operators that are written as words. */
    private fun nameEnd(from: Int): Int {
        var until = from
        while (until < text.length) {
            val character = text[until]
            if (character == ' ') {
                var nextFrom = until
                while (nextFrom < text.length && text[nextFrom] == ' ') nextFrom++
                val next = scanner.wordAt(nextFrom)
                if (next.isEmpty() || next.lowercase() in INFIX_WORDS) break
            } else if (!isWordCharacter(character) && character !in "/.:[]#") {
                break
            }
            until++
        }
        return maxOf(until, from + 1)
    }

    private fun ambiguityText(signal: String, topics: List<String>): String {
        // Cut to whole words, as a person would write the pattern.
        val start = topics.reduce { one, other -> one.commonPrefixWith(other) }.dropLastWhile(::isWordCharacter)
        val rest = topics.map { it.substring(start.length) }
        val end = rest.reduce { one, other -> one.commonSuffixWith(other) }.dropWhile(::isWordCharacter)
        val pattern = if (start.isEmpty() && end.isEmpty()) topics[0].substringBefore('/') + "/*" else "$start*$end"
        return "“$signal” means ${topics.size} topics, such as “${topics[0]}”; name one, or ask for each: max(\"$pattern\") by topic."
    }

    private fun failUnknownTopic(name: String, from: Int, until: Int): Nothing {
        vocabulary.missingMeaning(name)?.let {
            val message = "The log has no topic for the signal “$it”; name yours in badlog-signals.toml."
            throw Mistake(from, until, ExpressionErrorKind.UNKNOWN_TOPIC, message)
        }
        vocabulary.several.entries.find { it.key.equals(name, ignoreCase = true) }?.let { (signal, topics) ->
            throw Mistake(from, until, ExpressionErrorKind.AMBIGUOUS_TOPIC, ambiguityText(signal, topics))
        }
        val near = near(name)
        val suggestion = if (near.isEmpty()) "" else " Did you mean ${near.joinToString(" or ")}?"
        throw Mistake(from, until, ExpressionErrorKind.UNKNOWN_TOPIC, "${unknownNameText(name)}.$suggestion")
    }

    /** Returns names that [name] may have been meant to be, for a message. */
    private fun near(name: String) = listOfNotNull(
        vocabulary.nearestTopic(name)?.let { "“${it.name}”" },
        vocabulary.nearestMeaning(name)?.let { "`${it.name}`" },
    )

    /** Returns the beginning of a sentence that says that [name] means nothing here. */
    fun unknownNameText(name: String): String =
        "“$name” is not a ${vocabulary.thing}${if (vocabulary.meanings.isEmpty()) "" else " or signal"} of this log"

    private fun fail(from: Int, until: Int, message: String): Nothing = throw Mistake(from, until, ExpressionErrorKind.SYNTAX, message)

    private companion object {
        const val MAX_NAMED = 3
        const val NO_LIMIT = 1000
        val NAMES_IN_OTHER_TOOLS =
            mapOf("sum" to "integral", "avg" to "mean", "average" to "mean", "std" to "stddev", "diff" to "delta", "length" to "duration")
        val INFIX_WORDS = setOf("and", "or", "for", "when", "within", "contains", "matches")
    }
}
