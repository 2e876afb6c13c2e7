package badlog.files.terminal

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldEndWith
import java.io.ByteArrayOutputStream
import java.io.PrintStream

class ProgressBarSpec : FunSpec({
    val err = ByteArrayOutputStream()
    beforeTest { err.reset() }

    fun bar(isShown: Boolean, delay: Long) = ProgressBar("match.bag", PrintStream(err), isShown, delay)

    test("quick work, and work without a terminal, shows nothing") {
        bar(isShown = true, delay = Long.MAX_VALUE).use { it.advanced(1, 2) }
        bar(isShown = false, delay = 0).use { it.advanced(1, 2) }
        err.size() shouldBe 0
    }

    test("the bar grows, and leaves no trace") {
        bar(isShown = true, delay = 0).use { bar ->
            bar.advanced(1, 2)
            err.toString() shouldContain "match.bag [##########          ] 50 %"
            bar.advanced(3, 2)
            err.toString() shouldContain "] 100 %"
        }
        err.toString().substringAfterLast('%').filter { it != ' ' } shouldBe "\r\r"
    }

    test("the bar shows the remaining time at the speed so far, and fits a terminal") {
        var now = 0L
        ProgressBar("a-match-with-a-very-long-name-at-some-event.wpilog", PrintStream(err), isShown = true, delay = 0) { now }.use { bar ->
            fun after(seconds: Long, done: Long): String {
                err.reset()
                now = seconds * 1_000_000_000
                bar.advanced(done, 10_000)
                return err.toString().trim()
            }
            after(seconds = 1, done = 0) shouldEndWith "] 0 %"
            after(seconds = 2, done = 100) shouldEndWith "] 1 %, 3 min left"
            after(seconds = 30, done = 2_500) shouldEndWith "] 25 %, 2 min left"
            after(seconds = 31, done = 2_550) shouldEndWith "] 25 %, 2 min left"
            after(seconds = 40, done = 8_000) shouldEndWith "] 80 %, 10 s left"
            after(seconds = 9_000, done = 8_000) shouldEndWith "] 80 %, 38 min left"
            after(seconds = 90_000, done = 8_100) shouldEndWith "] 81 %, 6 h left"
            after(seconds = 90_001, done = 10_000) shouldEndWith "] 100 %"
            after(seconds = 1_000_000, done = 9_900).length shouldBeLessThanOrEqual 80
        }
    }

    test("an empty file counts as done") {
        bar(isShown = true, delay = 0).use { it.advanced(0, 0) }
        err.toString() shouldContain "100 %"
    }
})
