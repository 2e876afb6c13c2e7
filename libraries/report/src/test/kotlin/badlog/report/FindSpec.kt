package badlog.report

import badlog.expression.Outcome
import badlog.expression.syntax.ExpressionErrorKind
import badlog.files.inFolder
import badlog.files.terminal.displayWidth
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.types.shouldBeInstanceOf
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.nio.file.Files

class FindSpec : FunSpec({
    test("results are in the order of the files, for any number of them") {
        inFolder { folder ->
            for (i in 1..60) folder.put("Q$i.bag", batteryBag(12.0, 12.0 - i / 10.0, match = i))
            val reported = ArrayList<Int>()
            val results = Find("min(Battery Voltage) < 7").over(logsIn(folder), { done, _ -> reported += done })
            results.map { it.title } shouldContainExactly (1..60).map { "Mill Creek Qualification $it" }
            reported.filter { it > 0 }.distinct() shouldContainExactly (1..60).toList()
            results.filter { (it.reply as Reply.Answered).outcome == Outcome.HOLDS }.map { it.file.name } shouldContainExactly
                (51..60).map { "Q$it.bag" }
        }
    }

    test("logs without the topic and files that are not logs are distinguished") {
        inFolder { folder ->
            folder.put("1.bag", batteryBag(6.0))
            folder.put("2.bag", batteryBag(6.0, name = "Volts"))
            folder.put("3.csv", "just some words\nand more of them\n")
            folder.put("4.bag", batteryBag(6.0))
            val files = logsIn(folder)
            Files.delete(folder.resolve("4.bag"))
            val replies = Find("Battery Voltage < 7").over(files).map { it.reply }
            replies[0].shouldBeInstanceOf<Reply.Answered>().time shouldBe 0.0
            replies[1].shouldBeInstanceOf<Reply.NotAsked>().run {
                kind shouldBe ExpressionErrorKind.UNKNOWN_TOPIC
                topic shouldBe "Battery Voltage"
            }
            replies[2].shouldBeInstanceOf<Reply.Unreadable>().isNoLog shouldBe true
            replies[3].shouldBeInstanceOf<Reply.Unreadable>().run {
                message shouldContain "There is no file"
                isNoLog shouldBe false
            }
        }
    }

    test("a signal that is several topics is not unknown: the message shows how to ask for each") {
        inFolder { folder ->
            val names = listOf("Left/Drive Current", "Right/Drive Current").associateWith { "A" }
            folder.put("1.bag", bag(mapOf("Time" to "s") + names, listOf("0,10,20", "1,30,5")))
            folder.put("2/1.bag", bag(mapOf("Time" to "s", "Left/Drive Current" to "A"), listOf("0,10", "1,30")))
            val replies = Find("max(motor current)").over(logsIn(folder)).map { it.reply }
            replies[0].shouldBeInstanceOf<Reply.NotAsked>().message shouldBe
                "“motor current” means 2 topics, such as “Left/Drive Current”; name one, or ask for each: max(\"*/Drive Current\") by topic."
            replies[1].shouldBeInstanceOf<Reply.Answered>().quantities.single().value shouldBe 30.0
            Find("max(\"*/Drive Current\") by topic").over(logsIn(folder)).all { it.reply is Reply.Answered } shouldBe true
        }
    }

    test("the text reports findings, missing topics, and the place of a mistake") {
        inFolder { folder ->
            folder.put("1.bag", batteryBag(6.0))
            folder.put("long ${"x".repeat(120)}.bag", batteryBag(5.0))
            val files = logsIn(folder)
            findText(Find("Battery Voltage < 7").over(files)).lines().run {
                maxOf { it.length } shouldBeLessThanOrEqual 100
                last() shouldBe "Found in 2 of 2 logs."
            }
            findText(Find("Batery Voltage < 7").over(files)) shouldContain
                "Did you mean “System/Battery Voltage”?\nBatery Voltage < 7\n^^^"
            findText(Find("Battery Voltage <").over(files)) shouldContain "Something is missing here"
            findText(emptyList()) shouldBe "Found in 0 of 0 logs."
        }
    }

    test("a misspelled name is compared with the names of all logs, and the one that most of them have is suggested") {
        inFolder { folder ->
            folder.put("1.bag", batteryBag(6.0, name = "Other"))
            folder.put("2.bag", batteryBag(6.0, name = "Battery Voltages"))
            for (i in 3..4) folder.put("$i.bag", batteryBag(6.0))
            val results = Find("Batery Voltage < 7").over(logsIn(folder))
            findText(results) shouldContain "Did you mean “System/Battery Voltage”?\nBatery Voltage < 7\n^^^"
            mistakeIn(results).shouldNotBeNull().message shouldContain "Did you mean “System/Battery Voltage”?"
            val undefined = Find("P > 7", listOf("P = Batery Voltage * 2")).over(logsIn(folder)).map { it.undefined }
            undefinedTexts(undefined).single() shouldContain "Did you mean “System/Battery Voltage”?"
        }
    }

    test("the JSON has every file, and null for unknown values") {
        inFolder { folder ->
            folder.put("1.bag", batteryBag(6.0))
            folder.put("2.bag", batteryBag(6.0, name = "Volts"))
            val (first, second) = Find("Battery Voltage < 7").over(logsIn(folder)).map { jsonOf(FindJson(it)) }
            first.getValue("outcome").jsonPrimitive.content shouldBe "holds"
            first.getValue("figures").jsonArray[0].jsonObject.getValue("value").jsonPrimitive.content shouldBe "6.0"
            second.getValue("outcome").jsonPrimitive.content shouldBe "not_asked"
            second.getValue("topic").jsonPrimitive.content shouldBe "Battery Voltage"
            val infinite = jsonOf(FindJson(Find("Battery Voltage / 0").over(logsIn(folder))[0])).getValue("figures").jsonArray[0]
            infinite.jsonObject.getValue("value") shouldBe JsonNull
        }
    }

    test("files of one name are distinguished by their folders, and the columns are aligned in any script") {
        inFolder { folder ->
            for (name in listOf("a/m.bag", "b/m.bag", "機械.bag")) folder.put("logs/$name", bag(mapOf("Time" to "s", "V" to "V"), listOf("0,1")))
            val lines = findText(Find("V > 0").over(logsIn(folder))).lines()
            for (name in listOf("a/m.bag", "b/m.bag")) lines.count { it.startsWith("$name ") } shouldBe 1
            lines.take(4).map { displayWidth(it.substringBefore(" s  ")) }.drop(1).distinct().size shouldBe 1
        }
    }

    test("a file that did not change is not read again, one that did is") {
        inFolder { folder ->
            val cache = folder.resolve("cache")
            val one = folder.put("logs/1.bag", batteryBag(6.0))
            val two = folder.put("logs/2.bag", batteryBag(8.0, match = 2))
            fun ask(question: String = "min(Battery Voltage) < 7") = Find(question, cache = cache).over(logsIn(folder.resolve("logs"))).map { (it.reply as? Reply.Answered)?.quantities?.single()?.toString() }
            val first = ask()
            spoil(one)
            ask() shouldBe first
            Files.writeString(two, batteryBag(6.5, 6.6))
            ask()[1] shouldBe "min(Battery Voltage) = 6.5 V"
            ask("max(Battery Voltage) < 7")[0] shouldBe null
        }
    }

    test("a question may use virtual topics, and with another definition it is another question to the cache") {
        inFolder { folder ->
            val cache = folder.resolve("cache")
            folder.put("logs/1.bag", batteryBag(6.0, 12.0))
            fun ask(definition: String) = findText(Find("max(Double)", listOf(definition), cache).over(logsIn(folder.resolve("logs"))))
            ask("Double [V] = Battery Voltage * 2") shouldContain "24 V"
            ask("Double [V] = Battery Voltage * 3") shouldContain "36 V"
        }
    }

    test("a virtual topic that only some logs can have is reported once, with the reason") {
        inFolder { folder ->
            folder.put("1.bag", batteryBag(6.0))
            folder.put("2.bag", bag(mapOf("Time" to "s", "a" to "V"), listOf("0,1")))
            val text = findText(Find("max(Double)", listOf("Double = Battery Voltage * 2")).over(logsIn(folder)))
            text shouldContain "Found in 1 of 2 logs."
            text shouldContain "“Double = Battery Voltage * 2” is not in 1 log: “Battery Voltage” is not a topic"
        }
    }

    test("a virtual topic that no log can have is reported with the place of the mistake") {
        inFolder { folder ->
            folder.put("1.bag", batteryBag(6.0))
            val text = findText(Find("max(Battery Voltage)", listOf("Double = Batery Voltage * 2")).over(logsIn(folder)))
            text shouldContain "Double = Batery Voltage * 2\n         ^^^^^^"
        }
    }

    test("a log with losses is reported, also from the cache") {
        inFolder { folder ->
            folder.put("logs/1.bag", batteryBag(6.0))
            folder.put("logs/2.bag", batteryBag(6.0) + "0.1,\n0.2,12,3\n")
            repeat(2) {
                Find("min(Battery Voltage) < 7", cache = folder.resolve("cache")).over(logsIn(folder.resolve("logs")))
                    .map { it.isSalvaged } shouldContainExactly listOf(false, true)
            }
        }
    }

    test("results are kept if the listener throws, whatever it throws") {
        for (failure in listOf(IllegalStateException(), InterruptedException())) {
            inFolder { folder ->
                for (i in 1..3) folder.put("logs/$i.bag", batteryBag(6.0))
                val files = logsIn(folder.resolve("logs"))
                fun find() = Find("min(Battery Voltage) < 7", cache = folder.resolve("cache"))
                shouldThrow<Exception> {
                    find().over(files) {
                        Thread.currentThread().interrupt()
                        throw failure
                    }
                }
                Thread.interrupted() shouldBe true
                spoil(files[0].path)
                find().over(files)[0].reply.shouldBeInstanceOf<Reply.Answered>()
            }
        }
    }

    test("a damaged cache is ignored") {
        inFolder { folder ->
            val cache = folder.resolve("cache")
            folder.put("logs/1.bag", batteryBag(6.0))
            val files = logsIn(folder.resolve("logs"))
            fun ask() = Find("min(Battery Voltage) < 7", cache = cache).over(files).map { (it.reply as Reply.Answered).quantities.single().toString() }
            val first = ask()
            val kept = Files.list(cache).use { it.toList() }.single()
            val bytes = Files.readAllBytes(kept)
            for (at in listOf(0, 31, 32, bytes.size / 2, bytes.size - 1)) {
                Files.write(kept, bytes.copyOf().also { it[at] = (it[at] + 1).toByte() })
                ask() shouldBe first
                Files.write(kept, bytes.copyOf(at))
                ask() shouldBe first
            }
            Files.readAllBytes(kept).size shouldBe bytes.size
        }
    }

    test("a cache that cannot be written is not an error") {
        inFolder { folder ->
            val cache = folder.put("a file", "x").resolve("cache")
            folder.put("1.bag", batteryBag(6.0))
            Find("min(Battery Voltage) < 7", cache = cache).over(logsIn(folder)).size shouldBe 1
        }
    }

    test("an exception of the listener stops the work") {
        inFolder { folder ->
            for (i in 1..20) folder.put("Q$i.bag", batteryBag(12.0))
            shouldThrow<IllegalStateException> { Find("true").over(logsIn(folder), { done, _ -> check(done < 3) }) }
        }
    }
})
