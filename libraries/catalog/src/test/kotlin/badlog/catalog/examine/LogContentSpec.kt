package badlog.catalog.examine

import badlog.catalog.folder.bag
import badlog.catalog.folder.put
import badlog.files.LogFile
import badlog.signals.vocabulary.SignalVocabulary
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.string.shouldContain

private fun overflow(depth: Int): Int = overflow(depth + 1) + 1

class LogContentSpec : FunSpec({
    test("any failure in the work on a file is reported for this file") {
        val file = LogFile.of(tempdir().toPath().put("1.bag", bag()))
        fun messageAfter(fail: () -> Unit) = LogContent.examined(file, emptyList(), SignalVocabulary.NONE) { content ->
            if (content is LogContent.None) content.why.message else null.also { fail() }
        }.orEmpty()
        messageAfter { error("odd") } shouldContain "(java.lang.IllegalStateException: odd); report it"
        messageAfter { overflow(0) } shouldContain "StackOverflowError"
        messageAfter { throw OutOfMemoryError() } shouldContain "does not fit into the"
        shouldThrow<InterruptedException> { messageAfter { throw InterruptedException() } }
    }
})
