package badlog.cli.todo

import badlog.catalog.todo.TodoFolder
import badlog.catalog.todo.newChange
import badlog.cli.SAMPLES
import badlog.cli.badlog
import badlog.cli.badlogJson
import badlog.cli.command.ExitCode
import badlog.cli.inFolder
import badlog.cli.with
import badlog.viewer.todo.Check
import badlog.viewer.todo.FaultTask
import badlog.viewer.todo.OwnTask
import badlog.viewer.todo.TodoDeed
import badlog.viewer.todo.TodoSubject
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import kotlinx.serialization.json.jsonPrimitive
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.appendText
import kotlin.io.path.readText

class TodoSpec : FunSpec({
    fun Path.withMatch() = apply { Files.copy(SAMPLES.resolve("qualification-42.bag"), resolve("qualification-42.bag")) }

    // The log is years old, and so what was seen before it is not known.
    fun Path.write(subject: TodoSubject, deed: TodoDeed) = TodoFolder(this, "pit").append(newChange(subject, deed, "Ada", last = null).copy(seen = null))

    test("an error of the last matches is on the list, until it is done; the checklist has the lines of rules and those of the team") {
        inFolder { folder ->
            folder.withMatch().with("checklist.md", "- [ ] Bumpers are tight\n")
            val before = badlog("todo", folder, "--no-cache")
            before.code shouldBe ExitCode.WHOLE
            before.out shouldContain "[ ] Browned out\n"
            before.out shouldContain "Found in Qualification 42."
            before.out shouldContain "Checklist before the match after Qualification 42:"
            before.out shouldContain "[ ] The battery is charged: 12.6 V or more at rest.\n"
            before.out shouldContain "[ ] Bumpers are tight"
            folder.write(FaultTask("Browned out", "System/Browned Out"), TodoDeed.Done("new lead", "Qualification 43"))
            folder.write(OwnTask("Check the radio"), TodoDeed.Assign("Ben"))
            folder.write(Check("Bumpers are tight", "the match after Qualification 42"), TodoDeed.Done())
            val after = badlog("todo", folder, "--no-cache").out
            after shouldNotContain "[ ] Browned out"
            after shouldContain "[ ] Check the radio (Ben)"
            after shouldContain "[x] Bumpers are tight (Ada)"
            after shouldContain "Done:\n[x] Browned out\n    Done before Qualification 43 by Ada: new lead"
        }
    }

    test("programs get a line for each item, and Markdown is for people who write elsewhere") {
        inFolder { folder ->
            folder.withMatch().write(OwnTask("Check the *radio*"), TodoDeed.Open)
            val lines = badlogJson("todo", folder, "--no-cache").json
            lines.map { it.getValue("status").jsonPrimitive.content to it["item"]?.jsonPrimitive?.content } shouldContain
                ("open" to "Check the *radio*")
            badlog("todo", folder, "--markdown", "--no-cache").out shouldContain "- [ ] **Check the \\*radio\\***"
        }
    }

    test("the page replaces an earlier one, and nothing else") {
        inFolder { folder ->
            val page = folder.resolve("list.html")
            folder.write(OwnTask("Radio"), TodoDeed.Open)
            badlog("todo", folder, "--out", page).code shouldBe ExitCode.WHOLE
            folder.write(OwnTask("Ladder"), TodoDeed.Open)
            badlog("todo", folder, "--out", page).err shouldContain "The page is $page."
            page.readText() shouldContain "Ladder"
            val mine = folder.with("mine.html", "<p>mine</p>")
            val refused = badlog("todo", folder, "--out", mine)
            refused.code shouldBe ExitCode.NOTHING
            refused.err shouldContain "exists already, and badlog did not make it; use --force to replace it, or select another name."
            badlog("todo", folder, "--out", mine, "--force").code shouldBe ExitCode.WHOLE
            badlog("todo", folder, "--out", folder).err shouldContain "$folder is a folder; name another file, or one inside it."
        }
    }

    test("lines that cannot be read are reported, and cost nothing else; what is not a folder is refused") {
        inFolder { folder ->
            folder.write(OwnTask("Radio"), TodoDeed.Open)
            TodoFolder(folder, "pit").file.appendText("{\"id\":\n")
            val ended = badlog("todo", folder)
            ended.code shouldBe ExitCode.SALVAGED
            ended.err shouldContain "Line 2 of badlog-todo-pit.jsonl is skipped"
            ended.out shouldContain "[ ] Radio"
            ended.out shouldNotContain "No logs"
            badlog("todo", folder.resolve("gone")).err shouldContain "There is no file or folder ${folder.resolve("gone")}"
        }
    }
})
