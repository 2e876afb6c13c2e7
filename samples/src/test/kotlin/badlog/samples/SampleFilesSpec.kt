package badlog.samples

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.comparables.shouldBeLessThan
import io.kotest.matchers.shouldBe
import java.io.File

class SampleFilesSpec : FunSpec({
    for ((name, make) in SAMPLES.filterKeys { !it.endsWith(".gz") }) {
        test("$name equals the simulation's output, byte for byte") {
            make().contentEquals(sampleFile(name).readBytes()) shouldBe true
        }
    }

    // Other builds of zlib compress to different bytes that inflate to the same content.
    test("qualification-57.bag.gz inflates, up to its cut end, to the simulation's output") {
        val inflated = Inflated(sampleFile("qualification-57.bag.gz").readBytes()).bytes
        qualification57().copyOf(inflated.size).contentEquals(inflated) shouldBe true
    }

    test("the folder of samples has no other logs") {
        val files = File(".").listFiles().orEmpty().map { it.name }
        files.filter { it.endsWith(".bag") || it.endsWith(".gz") || it.endsWith(".csv") }.toSet() shouldBe SAMPLES.keys
    }

    test("all together are smaller than 3 MB") {
        SAMPLES.keys.sumOf { sampleFile(it).length() } shouldBeLessThan 3_000_000
    }
})
