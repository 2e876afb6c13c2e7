package badlog.cli.merge

import badlog.recording.Value
import badlog.rules.PART_VALUE
import badlog.text.freeName

/** Gives each topic, or each value, of a merge a name of its own. */
internal class MergedNames {
    private val taken = HashSet<String>()

    /** What is called otherwise than in its log. */
    val renamed = ArrayList<Renaming>()

    /** [name], or where that is taken, for the [reason] if there is one, [name] in a folder that is called like the file of [part]. */
    fun take(name: String, part: LogPart, reason: String = ""): String {
        if (taken.add(name)) return name
        val inFolder = "${part.folder}/$name"
        val free = freeName(inFolder, isFree = taken::add)
        renamed += Renaming(part, name, free, reason)
        return free
    }

    /** The values of all [parts], those that say the same once. */
    fun values(parts: List<LogPart>): List<Value> {
        val values = ArrayList<Value>()
        for (part in parts) {
            for (value in part.recording.values) {
                // Parts that are put together may be whole again.
                if (value.name != PART_VALUE && value !in values) values += value.copy(name = take(value.name, part))
            }
        }
        return values
    }
}

/** What is called [from] in [part] is called [to] in the merge, for the [reason] where that is not only that the name was taken. */
internal class Renaming(val part: LogPart, val from: String, val to: String, val reason: String = "")
