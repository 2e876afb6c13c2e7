package badlog.lib

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.io.File
import java.util.Locale

/** All in which a bag differs from the original's, each with what the original did. */
class DeviationSpec : FunSpec({
    test("an x axis has microseconds; the original left 10 ms of 100 s") {
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

    test("quotes, newlines and spaces at an end are quoted; the original wrote them bare") {
        inFolder { folder ->
            val file = logged(folder, {
                BadLog.createTopicStr("a \"b\"", "ul", { "say \"hi\",\nthen go" })
                BadLog.createTopicStr("Spaces, and a comma", "ul", { " x " })
            }) { it.row() }
            file.readText() shouldContain "\n\"a \"\"b\"\"\",\"Spaces, and a comma\"\n" +
                "\"say \"\"hi\"\",\nthen go\",\" x \"\n"
        }
    }

    test("files are UTF-8 and numbers have points anywhere; the original asked the machine") {
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

    test("folders are created; the original logged nothing then") {
        inFolder { folder ->
            val file = File(folder, "a/b/c.bag")
            BadLog.init(file.path).use { it.finishInitialization() }
            file.exists() shouldBe true
        }
    }
})
