package badlog.lib

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.io.File
import java.io.OutputStream
import java.io.PrintStream

class LoopFaultsSpec : FunSpec({
    test("a supplier that throws leaves a gap, is counted, reported once, and noted as an event in the log") {
        inFolder { folder ->
            val messages = standardErrorOf {
                val file = logged(folder, {
                    BadLog.createTopic("Good", "ul", { 1.0 })
                    BadLog.createTopic("Bad/Sensor", "ul", { throw IllegalStateException("unplugged") })
                    BadLog.createTopicBoolean("Worse", "ul", { throw NoClassDefFoundError("Vendor") })
                    BadLog.createEvents("Events")
                }) { log ->
                    repeat(3) { log.row() }
                    log.counters().cellsMissed shouldBe 6
                    log.counters().rowsWritten shouldBe 3
                    log.state shouldBe LogState.LOGGING
                }
                val rows = rowsIn(file)
                rows[0] shouldContain
                    "1.0000,,,\"The topic \"\"Bad/Sensor\"\" threw java.lang.IllegalStateException: unplugged"
                rows.drop(1) shouldBe List(2) { "1.0000,,," }
            }
            messages.trim().lines() shouldHaveSize 2
            messages shouldContain "Bad/Sensor"
        }
    }

    for ((mode, otherwise) in mapOf(DataInferMode.DEFAULT to "-1.0", DataInferMode.LAST to "enabled")) {
        test("without an event log, a subscriber with the attribute log and mode $mode takes the faults") {
            inFolder { folder ->
                standardErrorOf {
                    val file = logged(folder, {
                        BadLog.createTopic("Bad", "ul", { throw IllegalStateException() })
                        BadLog.createTopicSubscriber("Log", "ul", mode, "log")
                    }) { log ->
                        BadLog.publish("Log", "enabled")
                        repeat(3) { log.row() }
                    }
                    val rows = rowsIn(file)
                    rows[0] shouldBe ",enabled"
                    rows[1] shouldContain "The topic \"\"Bad\"\" threw"
                    rows[2] shouldBe ",$otherwise"
                }
            }
        }
    }

    test("names that a program invents leave room for the log's own messages") {
        val faults = Faults(Counters())
        standardErrorOf {
            for (i in 1..200) faults.publishIgnored("name $i") { "name $i" }
            for (i in 1..200) faults.callIgnored(if (i == 1) "full" else "call $i") { "call $i" }
            faults.reportOnce("full") { "full" }
            faults.reportOnce("full") { error("not made twice") }
        }.lines().count { it.isNotEmpty() } shouldBe 201
    }

    test("invalid publishing is ignored, counted, and reported once for each name") {
        inFolder { folder ->
            val messages = standardErrorOf {
                val file = logged(folder, {
                    BadLog.createTopic("Queried", "ul", { 1.0 })
                    BadLog.createTopicSubscriber("Published", "ul", DataInferMode.LAST)
                    BadLog.publish("Published", 1.0)
                    BadLog.publish("Early", 1.0)
                }) { log ->
                    repeat(2) {
                        BadLog.publish("Unknown", 1.0)
                        BadLog.publish("Queried", "2")
                        BadLog.publish(null, "3")
                        BadLog.publish("Published", null)
                    }
                    log.row()
                    log.counters().callsIgnored shouldBe 9
                }
                rowsIn(file) shouldBe listOf("1.0000,1.0000")
            }
            messages.trim().lines() shouldHaveSize 5
            messages shouldContain "\"Unknown\""
        }
    }

    test("a formatter that throws or returns null leaves a gap") {
        inFolder { folder ->
            val messages = standardErrorOf {
                val file = logged(folder, {
                    BadLog.createTopic("One", "ul", { 1.0 })
                    BadLog.createTopic("Two", "ul", { 2.0 })
                    BadLog.createTopic("Three", "ul", { 3.0 })
                }) { log ->
                    log.setDoubleToStringFunction {
                        if (it == 1.0) {
                            error("no ones")
                        } else if (it == 2.0) {
                            null
                        } else {
                            "three"
                        }
                    }
                    log.row()
                }
                rowsIn(file) shouldBe listOf(",,three")
            }
            messages shouldContain "no ones"
        }
    }

    test("a standard error without a reader neither stops the loop nor fills the memory") {
        val before = System.err
        val pipe = HeldDevice()
        val full = object : OutputStream() {
            override fun write(byte: Int) = pipe.hold()
        }
        StandardError.awaitPrinted(MAX_PRINT_MILLIS)
        try {
            System.setErr(PrintStream(full, true, "UTF-8"))
            inFolder { folder ->
                val file = logged(folder, { BadLog.createTopic("Bad", "ul", { throw IllegalStateException() }) }) { log ->
                    for (i in 1..3) {
                        BadLog.publish("Unknown $i", 1.0)
                        log.row()
                    }
                }
                rowsIn(file).size shouldBe 3
                repeat(1000) { StandardError.print("message $it") }
                StandardError.awaitPrinted(1) shouldBe false
                pipe.isWaitedFor shouldBe false
            }
        } finally {
            pipe.release()
            StandardError.awaitPrinted(MAX_PRINT_MILLIS) shouldBe true
            System.setErr(before)
        }
    }

    test("a standard error that throws does not end the reporting") {
        val before = System.err
        val messages = standardErrorOf {
            val captured = System.err
            System.setErr(object : PrintStream(captured) {
                override fun println(text: String?) = error("no console")
            })
            StandardError.print("one")
            StandardError.awaitPrinted(MAX_PRINT_MILLIS)
            System.setErr(captured)
            StandardError.print("two")
        }
        System.err shouldBe before
        messages shouldBe "badlog: two" + System.lineSeparator()
    }

    test("a formatter that logs, updates, flushes or closes in the middle of a row does not tear the row") {
        for (compress in listOf(false, true)) {
            inFolder { folder ->
                var calls = 0
                val messages = standardErrorOf {
                    BadLog.init("$folder/a.bag", compress, true).use { log ->
                        BadLog.createTopic("A", "ul", { 1.0 })
                        BadLog.createTopic("B", "ul", { calls.toDouble() })
                        log.finishInitialization()
                        log.setDoubleToStringFunction {
                            log.log()
                            log.updateTopics()
                            log.flush()
                            calls++
                            if (calls == 5) log.close()
                            "$it"
                        }
                        repeat(3) { log.row() }
                        log.state shouldBe LogState.CLOSED
                        // Six in formatters, and two calls after the end.
                        log.counters().callsIgnored shouldBe 12
                        log.counters().rowsWritten shouldBe 3
                    }
                }
                val file = File(folder, if (compress) "a.bag.gz" else "a.bag").readBytes()
                val bag = (if (compress) inflated(file) else file).decodeToString()
                bag.lines().drop(2) shouldBe listOf("1.0,0.0", "1.0,2.0", "1.0,4.0", "")
                messages shouldContain "log() is ignored while a row is being written"
            }
        }
    }

    test("a formatter that starts another log ends the first one after its row") {
        inFolder { folder ->
            var isSecond = false
            standardErrorOf {
                val file = logged(folder, {
                    BadLog.createTopic("A", "ul", { 1.0 })
                    BadLog.createTopic("B", "ul", { 2.0 })
                }) { log ->
                    log.setDoubleToStringFunction {
                        if (!isSecond) BadLog.init("$folder/second.bag").close()
                        isSecond = true
                        "$it"
                    }
                    repeat(2) { log.row() }
                }
                rowsIn(file) shouldBe listOf("1.0,2.0")
            }
        }
    }

    test("calls in the wrong order are ignored in the loop") {
        inFolder { folder ->
            standardErrorOf {
                val log = BadLog.init(File(folder, "a.bag").path)
                log.row()
                log.flush()
                log.finishInitialization()
                log.close()
                log.close()
                log.row()
                log.flush()
                BadLog.publish("A", 1.0)
                log.counters().callsIgnored shouldBe 5
            } shouldContain "finishInitialization"
        }
    }

    test("a supplier may publish, log, and update") {
        inFolder { folder ->
            var log: BadLog? = null
            val file = logged(folder, {
                BadLog.createTopic("A", "ul", {
                    BadLog.publish("B", 2.0)
                    log?.updateTopics()
                    1.0
                })
                BadLog.createTopicSubscriber("B", "ul", DataInferMode.DEFAULT)
            }) {
                log = it
                it.row()
            }
            rowsIn(file) shouldBe listOf("1.0000,2.0000")
        }
    }

    test("an interrupted thread continues to log") {
        inFolder { folder ->
            val file = logged(folder, { BadLog.createTopic("A", "ul", { 1.0 }) }) { log ->
                Thread.currentThread().interrupt()
                repeat(3) { log.row() }
                Thread.interrupted() shouldBe true
                log.state shouldBe LogState.LOGGING
            }
            rowsIn(file) shouldBe List(3) { "1.0000" }
        }
    }
})
