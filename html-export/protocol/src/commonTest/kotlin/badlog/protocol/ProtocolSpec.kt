package badlog.protocol

import badlog.core.analysis.Series
import badlog.core.analysis.Span
import badlog.core.json.quotedJson
import badlog.core.recording.Severity
import badlog.core.recording.Value
import badlog.rules.Finding
import badlog.rules.LogFindings
import badlog.rules.RuleSet
import badlog.rules.SkippedRule
import badlog.rules.fromJson
import badlog.rules.standing.PROVEN_TRUST
import badlog.rules.toJson
import badlog.viewer.choices.note.Note
import badlog.viewer.choices.note.NoteChange
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldNotContain
import io.kotest.property.Arb
import io.kotest.property.arbitrary.arbitrary
import io.kotest.property.arbitrary.boolean
import io.kotest.property.arbitrary.char
import io.kotest.property.arbitrary.choice
import io.kotest.property.arbitrary.constant
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.map
import io.kotest.property.arbitrary.orNull
import io.kotest.property.checkAll

private val HOSTILE = Arb.element(
    "</script>", "<!--", "<!--<script>", "\"", "\\", "\\u003c", "\u2028", "\u0000", "\uD800", "__proto__", "1", "",
)
private val TEXTS = Arb.list(Arb.choice(HOSTILE, Arb.char('\u0000'..'\uFFFF').map { it.toString() }), 0..5).map { it.joinToString("") }
private val FINITE = Arb.double(-1e300..1e300, includeNaNs = false).map { it + 0.0 }
private val SPANS = Arb.list(FINITE.map { Span(it, it + 1) }, 0..3)
private val NUMBERS = Arb.list(Arb.choice(Arb.double(), Arb.constant(Double.NaN)), 0..200).map { it.toDoubleArray() }

private val FINDINGS = arbitrary {
    Finding(
        rule = TEXTS.bind(),
        severity = Arb.element(Severity.entries).bind(),
        topic = TEXTS.orNull().bind(),
        text = TEXTS.bind(),
        time = Arb.choice(FINITE, Arb.constant(Double.NaN)).bind(),
        spans = SPANS.bind(),
        spanCount = Arb.int(0..Int.MAX_VALUE).bind(),
        timeUnit = TEXTS.bind(),
        isOfHook = Arb.boolean().bind(),
        evidence = Arb.list(TEXTS, 0..3).bind(),
        next = TEXTS.bind(),
        texts = Arb.list(TEXTS, 0..3).bind(),
        meanwhile = Arb.list(TEXTS, 0..3).bind(),
        caveats = Arb.list(TEXTS, 0..2).bind(),
        isForEach = Arb.boolean().bind(),
        trust = Arb.element(PROVEN_TRUST, 0.666, 0.05).bind(),
    )
}

private val HOOKS = arbitrary {
    HookPart(
        name = TEXTS.bind(),
        error = TEXTS.orNull().bind(),
        values = Arb.list(TEXTS.map { Value(it, "$it$it") }, 0..3).bind(),
        findings = Arb.list(FINDINGS, 0..2).bind(),
        series = Arb.list(NUMBERS.map { PageSeries("a", "V", Series(it, it)) }, 0..2).bind(),
        figures = Arb.list(TEXTS.map { PageFigure(it, "image/png", "AAEC") }, 0..2).bind(),
    )
}

/** Rules as a file's reader makes them, with hostile texts wherever a text may be. */
private val RULES = arbitrary {
    val text = quotedJson(TEXTS.bind().replace("{", "{{").replace("}", "}}"))
    val name = quotedJson(TEXTS.bind())
    val each = if (Arb.boolean().bind()) ",\"each\":{\"names\":[$name],\"except\":[],\"unit\":$name}" else ""
    val rule = "{\"name\":$name,\"severity\":\"note\",\"when\":$name,\"text\":$text,\"only\":[$name]$each," +
        "\"place\":{\"number\":3,\"line\":$name,\"column\":2,\"isLiteral\":true}}"
    val alias = "{\"name\":$name,\"names\":[$name],\"unit\":$name}"
    val signals = "{\"signals\":[{\"name\":$name,\"topics\":[$name,[$name,$name]]}],\"units\":[[$name,$name]],\"linked\":[[$name]]}"
    RuleSet.fromJson("{\"aliases\":[$alias],\"rules\":[$rule],\"signals\":$signals}").shouldNotBeNull()
}

class ProtocolSpec : FunSpec({
    fun partsOf(finding: Finding) = finding.run {
        val at = if (time.isNaN()) null else time
        listOf(rule, severity, topic, text, at, spans.map { it.from to it.to }, spanCount, timeUnit, isOfHook, evidence, next, texts, meanwhile, caveats, isForEach, trust)
    }

    fun bitsOf(series: PageSeries) = listOf(series.data.x, series.data.y).map { numbers -> numbers.map { it.toBits() } }

    fun partsOf(hook: HookPart) = hook.run {
        val lines = series.map { listOf(it.name, it.unit, bitsOf(it)) }
        listOf(name, error, values, findings.map(::partsOf), lines, figures.map { listOf(it.title, it.mediaType, it.base64) })
    }

    test("all content of a page is read back unchanged, and can neither end nor open an element") {
        checkAll(Arb.list(TEXTS, 0..3), RULES, Arb.list(FINDINGS, 0..3), Arb.list(HOOKS, 0..2)) { topics, rules, findings, hooks ->
            val additions = PageAdditions(topics, rules, topics.firstOrNull(), findings, hooks, video = topics.lastOrNull())
            val text = additions.toJson()
            text shouldNotContain "<"
            text.none { it.isSurrogate() } shouldBe true
            val read = PageAdditions.fromJson(text).shouldNotBeNull()
            read.virtualTopics shouldBe topics
            read.rules.toJson() shouldBe rules.toJson()
            read.rulesProblem shouldBe additions.rulesProblem
            read.video shouldBe additions.video
            read.findings.map(::partsOf) shouldBe findings.map(::partsOf)
            read.hooks.map(::partsOf) shouldBe hooks.map(::partsOf)
        }
    }

    test("notes and their changes are read back unchanged") {
        checkAll(100, Arb.list(TEXTS, 0..3)) { texts ->
            val notes = texts.filter { it.isNotBlank() }.mapIndexed { i, text -> Note(i + 0.5, text) }
            val time = "2026-03-07T14:05:12.345Z"
            val changes = notes.mapIndexed { i, note -> NoteChange("$i", time, "", note, isRemoved = i > 0, note.text) }
            val text = PageAdditions(notes = notes, noteChanges = changes).toJson()
            text shouldNotContain "<"
            val read = PageAdditions.fromJson(text).shouldNotBeNull()
            (read.notes to read.noteChanges) shouldBe (notes to changes)
        }
    }

    test("a log from another page is shown with only that page's notes") {
        val own = PageAdditions(field = "field", layout = "own", notes = listOf(Note(9.0, "own")))
        val shown = own.withNotesOf(PageAdditions(field = "other", layout = "other", notes = listOf(Note(1.0, "hit")), notesProblem = "One is missing."))
        listOf(shown.field, shown.layout, shown.notesProblem) shouldBe listOf("field", null, "One is missing.")
        shown.notes shouldBe listOf(Note(1.0, "hit"))
    }

    test("findings of the page's worker are read back unchanged") {
        checkAll(100, Arb.list(FINDINGS, 0..3), Arb.list(TEXTS, 0..3), Arb.boolean()) { findings, names, isMistake ->
            val skipped = names.map { SkippedRule(it, 1, "$it.", isMistake) }
            val read = logFindingsOf(LogFindings(findings, skipped).toJson()).shouldNotBeNull()
            read.findings.map(::partsOf) shouldBe findings.map(::partsOf)
            read.skipped.map { listOf(it.rule, it.logs, it.message, it.isMistake) } shouldBe
                skipped.map { listOf(it.rule, it.logs, it.message, it.isMistake) }
        }
    }

    test("cut or changed text is read as null, never in part") {
        val text = PageAdditions(findings = listOf(Finding("R", Severity.NOTE, null, "t", 1.0, emptyList(), 0, "s"))).toJson()
        for (end in text.indices) PageAdditions.fromJson(text.take(end)) shouldBe null
        PageAdditions.fromJson(text.replace("note", "bad")) shouldBe null
        PageAdditions.fromJson("{\"virtual\":[1],\"findings\":[],\"hooks\":[]}") shouldBe null
    }

    test("a figure is an SVG or a PNG") {
        shouldThrow<IllegalArgumentException> { PageFigure("A", "text/html", "") }
    }
})
