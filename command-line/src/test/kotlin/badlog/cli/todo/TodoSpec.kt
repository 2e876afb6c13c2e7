package badlog.cli.todo

import badlog.catalog.todo.TodoFolder
import badlog.catalog.todo.newChange
import badlog.cli.SAMPLES
import badlog.cli.badlog
import badlog.cli.badlogJson
import badlog.cli.command.ExitCode
import badlog.cli.with
import badlog.files.inFolder
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
import kotlinx.serialization.json.int
import kotlinx.serialization.json.jsonPrimitive
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.appendText
import kotlin.io.path.readText

class TodoSpec : FunSpec({
    fun Path.withMatch() = apply { Files.copy(SAMPLES.resolve("qualification-42.bag"), resolve("qualification-42.bag")) }

    // The log is years old, so earlier sightings are unknown.
    fun Path.write(subject: TodoSubject, deed: TodoDeed) = TodoFolder(this, "pit").append(newChange(subject, deed, "Ada", last = null).copy(seen = null))

    test("an error of the last matches is on the list until it is done; the checklist has the lines of rules and of the team") {
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
            after shouldContain "[x] Browned out\n      Done before Qualification 43 by Ada: new lead"
        }
    }

    test("an item is marked by its number as done and as to be done, in the file of this computer") {
        inFolder { folder ->
            folder.withMatch()
            val number = badlog("todo", folder, "--no-cache").out.lines().first { "Browned out" in it }.trim().substringBefore(' ')
            val done = badlog("todo", folder, "--no-cache", "--done", number, "--what", "new lead", "--by", "Ada")
            done.code shouldBe ExitCode.WHOLE
            done.err shouldContain "“Browned out” is done now."
            done.out shouldContain "[x] Browned out\n      Done after Qualification 42 by Ada: new lead"
            val change = TodoFolder(folder).read().changes.single()
            change.deed shouldBe TodoDeed.Done("new lead", "the match after Qualification 42")
            change.author shouldBe "Ada"
            val again = badlog("todo", folder, "--no-cache").out
            again shouldContain "[x] Browned out"
            val place = again.lines().first { "Browned out" in it }.trim().substringBefore(' ')
            badlog("todo", folder, "--no-cache", "--done", place, "--by", "Ben").err shouldContain
                "“Browned out” was done already; nothing was written. Describe the work with --what."
            TodoFolder(folder).read().changes.size shouldBe 1
            val more = badlog("todo", folder, "--no-cache", "--done", place, "--what", "new breaker", "--by", "Ben")
            more.err shouldContain "“Browned out” is done now."
            more.out shouldContain "[x] Browned out\n      Done after Qualification 42 by Ben: new breaker"
            val correction = TodoDeed.Done("new breaker", "the match after Qualification 42")
            TodoFolder(folder).read().changes.map { it.deed } shouldBe listOf(change.deed, correction)
            val opened = badlog("todo", folder, "--no-cache", "--open", place)
            opened.out shouldContain "[ ] Browned out"
            val openPlace = opened.out.lines().first { "Browned out" in it }.trim().substringBefore(' ')
            badlog("todo", folder, "--no-cache", "--open", openPlace).err shouldContain
                "“Browned out” is already open; nothing was written."
            TodoFolder(folder).read().changes.map { it.deed } shouldBe listOf(change.deed, correction, TodoDeed.Open)
        }
    }

    test("an impossible mark is refused, and nothing is written") {
        inFolder { folder ->
            folder.write(OwnTask("Radio"), TodoDeed.Open)
            val missing = badlog("todo", folder, "--done", "2")
            missing.code shouldBe ExitCode.USAGE
            missing.err shouldContain "The list has 1 item, but no number 2; badlog todo prints the numbers."
            badlog("todo", folder, "--done", "0").err shouldContain "no number 0"
            badlog("todo", folder, "--done", "1", "--open", "1").code shouldBe ExitCode.USAGE
            badlog("todo", folder, "--what", "new lead").code shouldBe ExitCode.USAGE
            badlog("todo", folder, "--by", "Ada").code shouldBe ExitCode.USAGE
            TodoFolder(folder, "pit").read().changes.size shouldBe 1
        }
    }

    test("programs get a line for each item, and Markdown is for people who write elsewhere") {
        inFolder { folder ->
            folder.withMatch().write(OwnTask("Check the *radio*"), TodoDeed.Open)
            val lines = badlogJson("todo", folder, "--no-cache").json
            lines.map { it.getValue("status").jsonPrimitive.content to it["item"]?.jsonPrimitive?.content } shouldContain
                ("open" to "Check the *radio*")
            lines.map { it["number"]?.jsonPrimitive?.int }.filterNotNull() shouldBe (1..lines.count { "item" in it }).toList()
            badlog("todo", folder, "--markdown", "--no-cache").out shouldContain "- [ ] **Check the \\*radio\\***"
        }
    }

    test("the page replaces only an earlier page") {
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
            refused.err shouldContain "exists already, and badlog did not make it; use --force to replace it, or name another place with --out."
            badlog("todo", folder, "--out", mine, "--force").code shouldBe ExitCode.WHOLE
            badlog("todo", folder, "--out", folder).err shouldContain "$folder is a folder; name another file, or one inside it."
        }
    }

    test("unreadable lines are reported and skipped; a path that is not a folder is refused") {
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
