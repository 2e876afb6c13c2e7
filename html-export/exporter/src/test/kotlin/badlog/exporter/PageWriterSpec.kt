package badlog.exporter

import badlog.core.recording.Severity
import badlog.protocol.HookPart
import badlog.protocol.PageAdditions
import badlog.rules.BUILT_IN
import badlog.rules.Finding
import badlog.rules.RuleSet
import badlog.viewer.choices.note.Note
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import io.kotest.matchers.string.shouldStartWith
import java.io.ByteArrayOutputStream

class PageWriterSpec : FunSpec({
    fun begin(title: String): String {
        val out = ByteArrayOutputStream()
        PageWriter(out, PageParts("", "")).begin(title)
        return out.toString()
    }

    test("a title is written unchanged, and does not change the lines around it") {
        val (before, after) = begin("match").split("match")
        for (title in listOf("  a", "a\nb", "\n    a\n  b\n", "\n", "", "\$1")) {
            begin(title) shouldBe before + title + after
        }
    }

    test("every kind of addition is in the page, even if it is the only one") {
        fun program(additions: PageAdditions): String {
            val out = ByteArrayOutputStream()
            PageWriter(out, PageParts("", "")).program(additions)
            return out.toString()
        }
        val finding = Finding("rule", Severity.NOTE, null, "Something else", Double.NaN, emptyList(), 0, "s")
        val note = Note(1.0, "look here")
        val all = listOf(
            PageAdditions(virtualTopics = listOf("P = 1")), PageAdditions(rules = RuleSet.BUILT_IN), PageAdditions(rulesProblem = "wrong"),
            PageAdditions(findings = listOf(finding)), PageAdditions(hooks = listOf(HookPart("hook"))),
            PageAdditions(differences = listOf(finding)), PageAdditions(layout = "{}"), PageAdditions(notes = listOf(note)),
            PageAdditions(notesProblem = "wrong"), PageAdditions(field = "{}"), PageAdditions(video = "match.mp4"),
        )
        all.forEach { program(it) shouldContain "id=\"packed-additions\"" }
        program(PageAdditions()) shouldNotContain "id=\"packed-additions\""
    }

    test("a page begins with the text by which the command line recognizes pages") {
        begin("a\nb") shouldStartWith PAGE_START
        begin("a\nb") shouldContain "<title>a\nb</title>\n<style>"
    }
})
