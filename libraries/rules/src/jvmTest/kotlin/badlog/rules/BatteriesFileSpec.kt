package badlog.rules

import badlog.signals.battery.TeamBattery
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.property.Arb
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll

private val FILE = """
    # Our batteries
    [[battery]]
    name = "A1"
    bought = "2025-01"

    [[battery]]
    name = "B2"
    bought = "2023-11-30"
    retired = true

    [used] # as on the sheet
    "Qualification 12" = "A1"
    elim = "B2"
""".trimIndent() + "\n"

class BatteriesFileSpec : FunSpec({
    test("the file lists the batteries, and the ones that were used") {
        val read = BatteriesFile.parse(FILE)
        read.batteries shouldBe listOf(TeamBattery("A1", "2025-01"), TeamBattery("B2", "2023-11-30", isRetired = true))
        read.used shouldBe mapOf("Qualification 12" to "A1", "elim" to "B2")
        read.usedFor(listOf("day1/x.bag"), "Qualification 12") shouldBe "A1"
        read.copy(used = read.used + ("day1/x.bag" to "B2")).usedFor(listOf("day1/x.bag"), "Qualification 12") shouldBe "B2"
        read.copy(used = read.used + ("x.bag" to "B2")).usedFor(listOf("day1/x.bag"), "Qualification 12") shouldBe "A1"
        BatteriesFile.parse("").batteries shouldBe emptyList()
    }

    test("writing the battery of a log leaves the rest of the file unchanged") {
        val added = BatteriesFile.withUse(FILE, "Qualification 13", "B2")
        added shouldBe FILE.replace("sheet\n", "sheet\n\"Qualification 13\" = \"B2\"\n")
        val changed = BatteriesFile.withUse(added, "Qualification 13", "A1")
        changed shouldBe added.replace("13\" = \"B2\"", "13\" = \"A1\"")
        BatteriesFile.withUse(changed, "Qualification 13", "") shouldBe FILE
        BatteriesFile.withUse("", "m.bag", "A1") shouldBe "[used]\n\"m.bag\" = \"A1\"\n"
    }

    test("any names of logs and batteries are read as written, changed, and removed") {
        checkAll(Arb.string(1, 20), Arb.string(1, 20)) { log, name ->
            val battery = name.trim().ifEmpty { "A1" }
            val written = BatteriesFile.withUse(FILE, log, battery)
            BatteriesFile.parse(written).used shouldBe mapOf("Qualification 12" to "A1", "elim" to "B2") + (log to battery)
            val changed = BatteriesFile.withUse(written, log, "A1")
            BatteriesFile.parse(changed).used[log] shouldBe "A1"
            BatteriesFile.withUse(changed, log, "") shouldBe FILE
        }
    }

    test("line ends and comments stay as they are") {
        val windows = FILE.replace("\n", "\r\n")
        BatteriesFile.withUse(windows, "m.bag", "A1") shouldBe windows.replace("sheet\r\n", "sheet\r\n\"m.bag\" = \"A1\"\r\n")
        val commented = FILE.replace("elim = \"B2\"", "elim = \"B2\" # swapped at lunch")
        BatteriesFile.withUse(commented, "elim", "A1") shouldBe commented.replace("elim = \"B2\"", "\"elim\" = \"A1\"")
        val owned = BatteriesFile.withUse(FILE, "m.bag", "A1").replace("\"m.bag\" = \"A1\"", "\"m.bag\" = \"A1\" # Ann's swap")
        BatteriesFile.withUse(owned, "m.bag", "B2") shouldBe owned.replace("\"m.bag\" = \"A1\"", "\"m.bag\" = \"B2\"")
    }

    for (text in listOf("used = { a = \"A1\" }\n", "[[battery]]\nname = \"A\"\n[used.x]\n", "used.\"a b\" = \"A1\"\n")) {
        test("what only a person can change is reported as such, as in ${text.replace("\n", " ")}") {
            val problem = shouldThrow<RulesException> { BatteriesFile.withUse(text, "b.bag", "B2") }
            problem.message.shouldContain(if (".x" in text) "“used” is a table" else "cannot be changed here")
        }
    }

    test("any text is read, or refused with a sentence about its mistake") {
        checkAll(Arb.string(0, 80)) { text ->
            try {
                BatteriesFile.parse("[[battery]]\nname = \"A\"\n$text")
            } catch (e: RulesException) {
                e.message.shouldContain(".")
            }
        }
    }

    for ((text, mistake) in listOf(
        "[[battery]]\nbought = \"2025\"" to "This battery has no “name”",
        "[[battery]]\nname = \"A\"\n[[battery]]\nname = \"A\"" to "There are two batteries named “A”",
        "[[battery]]\nname = \"A\"\nbought = \"last year\"" to "“bought” is a date",
        "[[battery]]\nname = \"A\"\nage = 3" to "“age” is not a key of a battery",
        "used = 3" to "“used” is a table",
        "[used]\na = 3" to "“used” is a table",
        "batteries = 3" to "“batteries” is not a key",
    )) {
        test("$mistake, as in ${text.replace("\n", " ")}") {
            shouldThrow<RulesException> { BatteriesFile.parse(text) }.message.shouldContain(mistake)
        }
    }
})
