package badlog.report.table

import badlog.core.recording.PathName
import badlog.core.recording.Value

/** Returns the value called [name], or with [name] as the last part of its path, regardless of case. Empty if there is none. */
internal fun headerOf(values: List<Value>, name: String): String {
    val value = values.find { it.name == name }
        ?: values.find { it.name.equals(name, ignoreCase = true) || PathName.baseNameOf(it.name).equals(name, ignoreCase = true) }
    return value?.text?.trim().orEmpty()
}

/** Compares two header values: numbers by size and before all texts, texts regardless of case. */
internal fun compareHeaders(one: String?, other: String?): Int = HEADERS.compare(one.orEmpty(), other.orEmpty())

private val HEADERS: Comparator<String> =
    compareBy<String, Double?>(nullsLast()) { it.toDoubleOrNull() }.then(String.CASE_INSENSITIVE_ORDER)
