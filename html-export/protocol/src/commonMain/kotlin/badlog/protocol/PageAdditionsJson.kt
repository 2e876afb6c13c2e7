package badlog.protocol

import badlog.core.analysis.Series
import badlog.core.json.JsonReader
import badlog.core.json.JsonValue
import badlog.core.json.quotedJson
import badlog.core.recording.Value
import badlog.rules.RuleSet
import badlog.rules.fromJson
import badlog.rules.toJson
import badlog.viewer.choices.note.NotesException
import badlog.viewer.choices.note.noteChangesOf
import badlog.viewer.choices.note.notesOfJson
import badlog.viewer.choices.note.toJson
import badlog.viewer.choices.note.toLines

/**
 * Returns these additions as JSON that is safe in a script element. Samples are written as base64 of their doubles, which is exact
 * and a third as long as digits.
 */
fun PageAdditions.toJson(): String = inScript(
    jsonObject(
        "virtual" to array(virtualTopics, ::quotedJson),
        "rules" to rules.takeIf { it.rules.isNotEmpty() || !it.signals.isEmpty }?.toJson(),
        "rulesProblem" to rulesProblem?.let(::quotedJson),
        "findings" to array(findings, ::findingJson),
        "hooks" to array(hooks, ::hookJson),
        "differences" to differences.takeIf { it.isNotEmpty() }?.let { array(it, ::findingJson) },
        "layout" to layout?.let(::quotedJson),
        "notes" to notes.takeIf { it.isNotEmpty() }?.toJson(),
        "noteLines" to noteChanges.takeIf { it.isNotEmpty() }?.let { quotedJson(it.toLines()) },
        "notesProblem" to notesProblem?.let(::quotedJson),
        "field" to field?.let(::quotedJson),
        "video" to video?.let(::quotedJson),
    ),
)

/** Returns the additions in [text], or null if [PageAdditions.toJson] did not write it. */
fun PageAdditions.Companion.fromJson(text: String): PageAdditions? = unlessMalformed {
    val json = JsonFields(JsonReader.readObject(text))
    PageAdditions(
        virtualTopics = json.list("virtual") { it.string },
        rules = json.find("rules")?.let { RuleSet.fromJson(it.members) ?: malformed() } ?: RuleSet.NONE,
        rulesProblem = json.find("rulesProblem")?.string,
        findings = json.list("findings", ::findingOf),
        hooks = json.list("hooks", ::hookOf),
        differences = if (json.find("differences") == null) emptyList() else json.list("differences", ::findingOf),
        layout = json.find("layout")?.string,
        notes = json.find("notes")?.let { notesIn(it.json) }.orEmpty(),
        notesProblem = json.find("notesProblem")?.string,
        field = json.find("field")?.string,
        video = json.find("video")?.string,
        noteChanges = noteChangesOf(json.find("noteLines")?.string.orEmpty()).changes,
    )
}

private fun notesIn(json: String) = try {
    notesOfJson(json)
} catch (_: NotesException) {
    malformed()
}

private fun hookJson(hook: HookPart): String = jsonObject(
    "name" to quotedJson(hook.name),
    "error" to hook.error?.let(::quotedJson),
    "values" to array(hook.values) { "[${quotedJson(it.name)},${quotedJson(it.text)}]" },
    "findings" to array(hook.findings, ::findingJson),
    "series" to array(hook.series) { series ->
        jsonObject(
            "name" to quotedJson(series.name),
            "unit" to quotedJson(series.unit),
            "x" to quotedJson(base64OfDoubles(series.data.x)),
            "y" to quotedJson(base64OfDoubles(series.data.y)),
        )
    },
    "figures" to array(hook.figures) {
        jsonObject("title" to quotedJson(it.title), "type" to quotedJson(it.mediaType), "data" to quotedJson(it.base64))
    },
)

private fun hookOf(value: JsonValue): HookPart {
    val json = JsonFields(value.members)
    return HookPart(
        name = json["name"].string,
        error = json.find("error")?.string,
        values = json.list("values") { pair ->
            val (name, text) = pair.items ?: malformed()
            Value(name.string, text.string)
        },
        findings = json.list("findings", ::findingOf),
        series = json.list("series") { series ->
            val fields = JsonFields(series.members)
            val data = Series(doublesOfBase64(fields["x"].string), doublesOfBase64(fields["y"].string))
            PageSeries(fields["name"].string, fields["unit"].string, data)
        },
        figures = json.list("figures") { figure ->
            val fields = JsonFields(figure.members)
            PageFigure(fields["title"].string, fields["type"].string, fields["data"].string)
        },
    )
}

/** Returns the base64 of [numbers] as little-endian doubles. */
internal expect fun base64OfDoubles(numbers: DoubleArray): String

/** Returns the doubles from which [base64OfDoubles] made [base64]. */
internal expect fun doublesOfBase64(base64: String): DoubleArray
