package badlog.cli.merge

import badlog.core.recording.Value
import badlog.core.text.freeName
import badlog.rules.PART_VALUE

/** Gives each topic, or each value, of a merge a unique name. */
internal class MergedNames {
    private val taken = HashSet<String>()

    /** The topics or values that have another name in their log. */
    val renamed = ArrayList<Renaming>()

    /** Returns [name]. If it is taken, returns it in a folder with the file name of [part], and records that with [reason]. */
    fun take(name: String, part: LogPart, reason: String = ""): String {
        if (taken.add(name)) return name
        val inFolder = "${part.folder}/$name"
        val free = freeName(inFolder, isFree = taken::add)
        renamed += Renaming(part, name, free, reason)
        return free
    }

    /** Returns the values of all [parts], without duplicates. */
    fun values(parts: List<LogPart>): List<Value> {
        val values = ArrayList<Value>()
        for (part in parts) {
            for (value in part.recording.values) {
                // Merged parts may be a whole log again.
                if (value.name != PART_VALUE && value !in values) values += value.copy(name = take(value.name, part))
            }
        }
        return values
    }
}

/** A topic or value called [from] in [part] and [to] in the merge. [reason] is empty if the name was merely taken. */
internal class Renaming(val part: LogPart, val from: String, val to: String, val reason: String = "")
