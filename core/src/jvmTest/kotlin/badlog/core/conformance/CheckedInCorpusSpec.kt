package badlog.core.conformance

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldBeUnique
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.shouldBe

class CheckedInCorpusSpec : FunSpec({
    test("each case has a name of its own") {
        CONFORMANCE_CASES.map { it.name }.shouldBeUnique()
    }

    test("the folder holds the files of the generator, no more and no fewer") {
        corpusFileNames().filter(::isConformanceFile) shouldContainExactlyInAnyOrder conformanceFiles().keys
    }

    test("each file equals the output of ./gradlew :core:writeConformance") {
        val stale = conformanceFiles().filterNot { (name, bytes) -> readCorpusFile(name).contentEquals(bytes) }
        stale.keys.shouldBeEmpty()
        // Not compared with a matcher, which would print thousands of lines.
        (readCorpusFile(NUMBER_CORPUS).decodeToString() == numberCorpus()) shouldBe true
    }
})
