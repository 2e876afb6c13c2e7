package badlog.lib

import badlog.core.recording.ProblemKind
import badlog.robots.NullArguments
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.io.File
import java.util.Locale

/** All differences from a bag of the original, each with the original's behavior. */
class DeviationSpec : FunSpec({
    test("an x axis has microseconds; the original resolved only 10 ms from 100 s on") {
        inFolder { folder ->
            var time = 100.0
            val file = logged(folder, {
                BadLog.createTopic("Time", "s", { time }, "xaxis", "hide")
                BadLog.createTopicDouble("Twin", "s", { time })
            }) { log ->
                log.row()
                time = 100.02
                log.row()
                log.setDoubleToStringFunction { "%.1f".format(Locale.ROOT, it) }
                log.row()
            }
            rowsIn(file) shouldBe listOf("100.000000,100.00", "100.020000,100.02", "100.0,100.0")
        }
    }

    test("texts with quotes, newlines or outer spaces are quoted; the original did not quote them") {
        inFolder { folder ->
            val file = logged(folder, {
                BadLog.createTopicStr("a \"b\"", "ul", { "say \"hi\",\nthen go" })
                BadLog.createTopicStr("Spaces, and a comma", "ul", { " x " })
            }) { it.row() }
            file.readText() shouldContain "\n\"a \"\"b\"\"\",\"Spaces, and a comma\"\n" +
                "\"say \"\"hi\"\",\nthen go\",\" x \"\n"
        }
    }

    test("files are UTF-8 and numbers have points on any machine; the original used the machine's settings") {
        val before = Locale.getDefault()
        Locale.setDefault(Locale.FRANCE)
        try {
            inFolder { folder ->
                val file = logged(folder, {
                    BadLog.createTopic("Angle", "°", { 1.5 })
                    BadLog.createTopicStr("Été", "ul", { "🤖" })
                }) { it.row() }
                file.readText() shouldContain "\nAngle,Été\n1.5000,🤖\n"
            }
        } finally {
            Locale.setDefault(before)
        }
    }

    test("line ends are \\n on any machine; the original used the machine's") {
        inFolder { folder ->
            val file = logged(folder, { BadLog.createTopic("A", "ul", { 1.0 }) }) { it.row() }
            file.readText() shouldContain "]}\nA\n1.0000\n"
            file.readText().contains('\r') shouldBe false
        }
    }

    test("characters that titles cannot hold are replaced in both header lines; the original broke the file") {
        for (name in listOf("a\nb", "a\rb", "a\r\nb", "\n", "a\u0000b", "\uD83E", "a\uDD16b", "x\uD83E", "\u0000")) {
            inFolder { folder ->
                standardErrorOf {
                    val file = logged(folder, {
                        BadLog.createTopicSubscriber(name, "s", DataInferMode.LAST, "xaxis", "hide")
                        BadLog.createTopic("Other", "V", { 2.0 })
                    }) { log ->
                        BadLog.publish(name, 1.5)
                        log.row()
                    }
                    recordingIn(file).run {
                        topics.map { it.unit to it.attributes } shouldBe listOf("s" to listOf("xaxis", "hide"), "V" to emptyList())
                        topics[0].samples.toList() shouldBe listOf(1.5)
                        problems.map { it.kind }.filter { it != ProblemKind.UNUSUAL_NAME }.shouldBeEmpty()
                    }
                }
            }
        }
    }

    test("NUL and half of a surrogate pair are U+FFFD in a cell") {
        inFolder { folder ->
            val file = logged(folder, { BadLog.createTopicStr("Text", "ul", { "a\u0000b\uD83E" }) }) { it.row() }
            rowsIn(file) shouldBe listOf("a\uFFFDb\uFFFD")
        }
    }

    test("a supplier or an array of attributes that is null is refused when its topic is created; the original threw in the loop") {
        inFolder { folder ->
            logged(folder, { NullArguments.createAll() shouldBe 11 }) { it.row() }
        }
    }

    test("publishing before init is ignored; the original threw") {
        BadLog.publish("Nowhere", 1.0)
        BadLog.publish("Nowhere", "text")
    }

    test("null is a gap; the original wrote \"null\" or threw") {
        inFolder { folder ->
            standardErrorOf {
                val file = logged(folder, {
                    BadLog.createTopic("Number", "ul", { null })
                    BadLog.createTopicStr("Text", "ul", { null })
                    BadLog.createTopic("Fine", "ul", { 1.0 })
                }) { it.row() }
                rowsIn(file) shouldBe listOf(",,1.0000")
            }
        }
    }

    test("a row before the first update has gaps; the original threw") {
        inFolder { folder ->
            val file = logged(folder, {
                BadLog.createTopic("Number", "ul", { 1.0 })
                BadLog.createTopicSubscriber("Published", "ul", DataInferMode.LAST)
            }) { it.log() }
            rowsIn(file) shouldBe listOf(",-1.0")
        }
    }

    test("a row of one empty text is not a blank line") {
        inFolder { folder ->
            val file = logged(folder, { BadLog.createTopicStr("Text", "ul", { "" }) }) { it.row() }
            rowsIn(file) shouldBe listOf("\"\"")
        }
    }

    test("missing folders are created; the original then logged nothing") {
        inFolder { folder ->
            val file = File(folder, "a/b/c.bag")
            BadLog.init(file.path).use { it.finishInitialization() }
            file.exists() shouldBe true
        }
    }
})
