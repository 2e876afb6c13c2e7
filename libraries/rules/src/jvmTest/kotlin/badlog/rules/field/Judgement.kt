package badlog.rules.field

/** A person's judgement of a finding, after comparing it with the samples of its log. */
internal enum class Judgement { TRUE, FALSE, UNKNOWN }

/**
 * Returns the judgements in [text]. Each line has the beginning of the log's hash, the rule, the second (`-` for the whole log), and
 * `true`, `false` or `unknown`, with tabs between them. The rest of the line is a remark, and a line that begins with `#` is one, too.
 * Throws [IllegalArgumentException] with the number of a line that is none of these.
 */
internal fun judgementsIn(text: String): Map<Firing, Judgement> = text.lines().withIndex()
    .filter { (_, line) -> line.isNotBlank() && !line.startsWith("#") }
    .associate { (at, line) ->
        val parts = line.split('\t')
        val judgement = parts.getOrNull(3)?.let { name -> Judgement.entries.find { it.name.equals(name.trim(), ignoreCase = true) } }
        val second = parts.getOrNull(2)
        require(judgement != null && second != null && (second == WHOLE || second.toLongOrNull() != null)) {
            "Line ${at + 1} is no judgement. It needs the log's hash, the rule, the second or -, and true, false or unknown, with tabs between them."
        }
        Firing(parts[0], parts[1], second.toLongOrNull()) to judgement
    }

/** Returns the beginning of a line of judgements for [firing]. */
internal fun lineOf(firing: Firing): String = "${firing.log}\t${firing.rule}\t${firing.second ?: WHOLE}\t"

private const val WHOLE = "-"
