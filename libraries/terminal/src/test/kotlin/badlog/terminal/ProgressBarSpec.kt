package badlog.terminal

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.io.ByteArrayOutputStream
import java.io.PrintStream

class ProgressBarSpec : FunSpec({
    val err = ByteArrayOutputStream()
    beforeTest { err.reset() }

    fun bar(isShown: Boolean, delay: Long) = ProgressBar("match.bag", PrintStream(err), isShown, delay)

    test("what is quick, or not on a terminal, shows nothing") {
        bar(isShown = true, delay = Long.MAX_VALUE).use { it.advanced(1, 2) }
        bar(isShown = false, delay = 0).use { it.advanced(1, 2) }
        err.size() shouldBe 0
    }

    test("it grows, and leaves no trace") {
        bar(isShown = true, delay = 0).use { bar ->
            bar.advanced(1, 2)
            err.toString() shouldContain "match.bag [#################                 ] 50 %"
            bar.advanced(3, 2)
            err.toString() shouldContain "] 100 %"
        }
        err.toString().substringAfterLast('%').filter { it != ' ' } shouldBe "\r\r"
    }

    test("an empty file is done") {
        bar(isShown = true, delay = 0).use { it.advanced(0, 0) }
        err.toString() shouldContain "100 %"
    }
})
