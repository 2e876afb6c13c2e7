package badlog.report

import badlog.signals.vocabulary.SignalVocabulary
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.string.shouldContain

private fun overflow(depth: Int): Int = overflow(depth + 1) + 1

class LogContentSpec : FunSpec({
    test("whatever fails in the work on a file is reported for this file") {
        inFolder { folder ->
            folder.put("1.bag", batteryBag(6.0))
            val file = logsIn(folder).single()
            fun messageAfter(fail: () -> Unit) = LogContent.examined(file, emptyList(), SignalVocabulary.NONE) { content ->
                if (content is LogContent.None) content.message else null.also { fail() }
            }.orEmpty()
            messageAfter { error("odd") } shouldContain "(java.lang.IllegalStateException: odd); report it"
            messageAfter { overflow(0) } shouldContain "StackOverflowError"
            messageAfter { throw OutOfMemoryError() } shouldContain "too large for the available memory"
            shouldThrow<InterruptedException> { messageAfter { throw InterruptedException() } }
        }
    }
})
