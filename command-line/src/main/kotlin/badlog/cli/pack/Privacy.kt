package badlog.cli.pack

import badlog.core.recording.Recording
import badlog.core.recording.TextColumn
import badlog.core.recording.Topic
import badlog.core.recording.Value

/**
 * Removes the traces of a log's owner: team number, network addresses, names of people and of their files. Numbers stay, and so do the names
 * of topics and of the event.
 */
internal class Privacy(recording: Recording) {
    /** The kinds of removed texts, in the order of the report. */
    enum class Kind(val noun: String, val nouns: String, val mark: String) {
        TEAM("team number", "team numbers", "[team]"),
        ADDRESS("address", "addresses", "[address]"),
        PERSON("name of a user or computer", "names of users and computers", "[user]"),
        PATH("path", "paths", "[path]"),
    }

    /** The number of removals of each kind. */
    val removed: Map<Kind, Int> get() = counts
    private val counts = sortedMapOf<Kind, Int>()

    private val texts = recording.values.map { it.text } + recording.topics.flatMap { it.texts.dictionary + it.metadata }
    private val known = buildList {
        for (text in texts) {
            for (form in USERS_OF_PATHS) form.findAll(text).forEach { add(Kind.PERSON to it.groupValues[1].trim()) }
            TEAM_OF_TEXT.findAll(text).forEach { add(Kind.TEAM to it.groupValues.drop(1).first(String::isNotEmpty)) }
            TEAM_ADDRESS.findAll(text).forEach { found ->
                val (high, low) = found.destructured
                add(Kind.TEAM to "${high.toInt() * 100 + low.toInt()}")
            }
        }
        for (value in recording.values) if (isTeam(value.name)) add(Kind.TEAM to value.text.trim())
        for (topic in recording.topics.filter { isTeam(it.name) }) {
            addAll(topic.texts.dictionary.map { Kind.TEAM to it.trim() })
            addAll(topic.samples.filter { it.isFinite() }.distinct().map { Kind.TEAM to "${it.toLong()}" })
        }
    }.distinct().filter { (kind, text) -> isDistinctive(kind, text) }

    private val words = known.map { (kind, text) -> kind to wordOf(text) }

    /** Returns [recording], the examined one or a part of it, without private texts. */
    fun without(recording: Recording): Recording = recording.copy(
        // Keys of the first line that badlog does not know may hold anything.
        headerLine = null,
        values = recording.values.map(::without),
        topics = recording.topics.filter { !isNumberOfTeam(it) }.map(::without),
    )

    /** Returns [text] with marks in place of its private parts. */
    fun without(text: String): String {
        val general = FORMS.fold(text) { left, (kind, form) -> form.replace(left, kind) }
        return words.fold(general) { left, (kind, form) -> form.replace(left, kind) }
    }

    private fun Regex.replace(text: String, kind: Kind): String = replace(text) {
        count(kind)
        kind.mark
    }

    private fun without(value: Value): Value = when {
        value.text.isBlank() -> value

        isTeam(value.name) -> value.copy(text = removed(Kind.TEAM))

        isPerson(value.name) -> value.copy(text = removed(Kind.PERSON))

        // The number of a match may equal the team's.
        endOf(value.name).startsWith("match") -> value

        else -> value.copy(text = without(value.text))
    }

    private fun without(topic: Topic): Topic {
        val kind = if (isTeam(topic.name)) Kind.TEAM else Kind.PERSON.takeIf { isPerson(topic.name) }
        val texts = topic.texts.dictionary.map { text ->
            if (kind != null && text.isNotBlank()) removed(kind) else without(text)
        }
        val metadata = without(topic.metadata)
        val cleaned = topic.copy(metadata = metadata)
        return if (texts == topic.texts.dictionary) cleaned else cleaned.copy(texts = topic.texts.with(texts))
    }

    /** Returns these texts with [texts] as the dictionary, each only once. */
    private fun TextColumn.with(texts: List<String>): TextColumn {
        val dictionary = texts.distinct()
        val place = dictionary.withIndex().associate { (index, text) -> text to index }
        return TextColumn(rows, IntArray(ids.size) { place.getValue(texts[ids[it]]) }, dictionary)
    }

    private fun isNumberOfTeam(topic: Topic): Boolean {
        val isOne = isTeam(topic.name) && topic.counts.run { numbers + notFinite } > 0
        if (isOne) count(Kind.TEAM)
        return isOne
    }

    private fun removed(kind: Kind): String {
        count(kind)
        return kind.mark
    }

    private fun count(kind: Kind) {
        counts.merge(kind, 1, Int::plus)
    }

    private companion object {
        /** Returns a pattern for [text] as a whole word: 1014 is not in 21014 or 10.14. */
        fun wordOf(text: String) = Regex("(?<![0-9A-Za-z.])${Regex.escape(text)}(?![0-9A-Za-z]|\\.\\d)", RegexOption.IGNORE_CASE)

        fun isTeam(name: String) = endOf(name) in TEAM_NAMES

        fun isPerson(name: String) = endOf(name).let { end -> PERSON_NAMES.any(end::endsWith) }

        private fun endOf(name: String) = name.substringAfterLast('/').lowercase().filter { it.isLetterOrDigit() }

        /** Returns whether [text] can be searched for. A short number or name would also be a part of unrelated texts. */
        fun isDistinctive(kind: Kind, text: String) = text.length >= SHORTEST && when (kind) {
            Kind.TEAM -> text.length <= LONGEST_TEAM && text.all(Char::isDigit)
            else -> text.lowercase() !in NOBODY
        }

        const val SHORTEST = 3
        const val LONGEST_TEAM = 5
        val TEAM_NAMES = setOf("team", "teamnumber", "teamno", "teamid")
        val PERSON_NAMES = listOf("user", "username", "author", "login", "hostname", "computername", "buildmachine")
        val NOBODY = setOf("lvuser", "admin", "root", "public", "shared", "default", "user", "users", "systemcore")

        private const val BYTE = "(?:25[0-5]|2[0-4]\\d|1?\\d?\\d)"
        private val TEAM_ADDRESS = Regex("(?<![\\w.])10\\.(\\d{1,3})\\.(\\d{1,2})\\.\\d{1,3}(?!\\w|\\.\\d)")
        private val TEAM_OF_TEXT = Regex("(?i)\\b(?:(?:frc|team)[ _#-]{0,2}(\\d{1,5})|roborio-(\\d{1,5})-frc)\\b")
        val USERS_OF_PATHS = listOf(Regex("/(?:home|Users)/([^\\\\/\\s\"':]+)"), Regex("(?i)[\\\\/]+Users[\\\\/]+([^\\\\/\"':\\n]+)"))

        /** The patterns of private texts. Paths come first, because they contain names of users. */
        val FORMS = listOf(
            Kind.PATH to Regex("file:/+[^\\s\"'<>]+"),
            Kind.PATH to Regex("(?<!\\w)[A-Za-z]:[\\\\/](?!/)(?:[^\\\\/\"'<>|:;,\\n\\r]+[\\\\/]+)*[^\\s\"'<>|:;,()\\[\\]]*"),
            Kind.PATH to Regex("\\\\\\\\[\\w.$-]+\\\\[^\\s\"'<>|;,]*"),
            Kind.PATH to
                Regex("(?<![\\w/.])(?:~|/(?:home|Users|root|media|mnt|tmp|var|opt|usr|etc|private|Volumes|u|U))/[^\\s\"'<>|:;,()\\[\\]]*"),
            Kind.PERSON to Regex("[\\w.+-]+@[\\w-]+(?:\\.[\\w-]+)+"),
            Kind.ADDRESS to Regex("(?i)\\broborio-\\d{1,5}-frc(?:\\.\\w+)*"),
            Kind.ADDRESS to Regex("(?<![\\w.])(?:$BYTE\\.){3}$BYTE(?!\\w|\\.\\d)"),
            // Of version 6, and of network cards.
            Kind.ADDRESS to
                Regex(
                    "(?i)(?<![\\w:])(?:(?:[0-9a-f]{1,4}:){5,7}[0-9a-f]{1,4}|(?:[0-9a-f]{1,4}:){1,6}:[0-9a-f:]*[0-9a-f]|(?:[0-9a-f]{2}-){5}[0-9a-f]{2})(?![\\w:])",
                ),
            Kind.TEAM to Regex("(?i)\\b(?:frc|team)[ _#-]{0,2}\\d{1,5}\\b"),
        )
    }
}
