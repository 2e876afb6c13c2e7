package badlog.viewer.todo

import badlog.core.recording.Severity
import badlog.signals.match.MatchOfLog
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain

class TodoPageSpec : FunSpec({
    val fault = FoundFault(FaultTask("Browned out", null), Severity.ERROR, "The battery fell to 6.1 V.")
    val log = TodoLog("q58.bag", MatchOfLog(null, "Qualification", "58"), 5000, listOf(fault))
    fun change(id: Int, subject: TodoSubject, deed: TodoDeed) = TodoChange("$id", "2026-03-07T14:05:0$id.000Z", "Ada", subject, deed)
    val list = TodoList.of(
        listOf(
            change(1, OwnTask("Tighten <b>everything</b> [*now*]"), TodoDeed.Assign("Ben")),
            change(2, OwnTask("Radio"), TodoDeed.Done("new cable", "Qualification 58")),
            change(3, Check("Battery in", "the match after Qualification 58"), TodoDeed.Done()),
        ),
        listOf(log),
    )
    val checklist = checklistOf("# Before the match\n\n- [ ] Battery in\n* Bumpers tight\n1. Radio on\nRadio on\n\n-5 V rail\n")

    test("a checklist has each line of a file, without headings and the signs of a list") {
        checklist shouldBe listOf("Battery in", "Bumpers tight", "Radio on", "-5 V rail")
    }

    test("the list is Markdown with every text unchanged") {
        list.toMarkdown(checklist) shouldBe """
            |# To do
            |
            |- [ ] **Browned out**${"  "}
            |  The battery fell to 6.1 V.${"  "}
            |  Found in Qualification 58.
            |
            |- [ ] **Tighten \<b\>everything\</b\> \[\*now\*\]** (Ben)
            |
            |## Checklist before the match after Qualification 58
            |
            |- [x] Battery in (Ada)
            |- [ ] Bumpers tight
            |- [ ] Radio on
            |- [ ] \-5 V rail
            |
            |## Done
            |
            |- [x] **Radio**${"  "}
            |  Done before Qualification 58 by Ada: new cable
            |
        """.trimMargin()
    }

    test("no text makes a list, a heading, a struck line or a mention") {
        fun line(text: String) = TodoList.of(listOf(change(1, OwnTask(text), TodoDeed.Open)), emptyList()).toMarkdown().lines()[2]
        line("1. ~~ask~~ @team") shouldBe "- [ ] **1\\. \\~\\~ask\\~\\~ \\@team**"
        line("--- &amp; 2.5 V") shouldBe "- [ ] **\\--- \\&amp; 2.5 V**"
    }

    test("the page has the same content, no script, and no text that is markup") {
        val page = list.toPage("logs & more", checklist)
        page shouldContain "<h1>To do: logs &amp; more</h1>"
        page shouldContain "<b>Tighten &lt;b&gt;everything&lt;/b&gt; [*now*]</b> <span>Ben</span>"
        page shouldContain "<p>Done before Qualification 58 by Ada: new cable</p>"
        page shouldContain "<b>Browned out</b> <span>error</span>"
        page shouldContain "Bumpers tight"
        page shouldNotContain "<script"
        isTodoPage(page.take(1000)) shouldBe true
        isTodoPage("<!DOCTYPE html>") shouldBe false
        TodoList.EMPTY.toPage("logs") shouldContain "<p>Nothing is open.</p>"
    }
})
