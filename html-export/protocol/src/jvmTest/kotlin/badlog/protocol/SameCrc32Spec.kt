package badlog.protocol

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.byte
import io.kotest.property.arbitrary.byteArray
import io.kotest.property.arbitrary.int
import io.kotest.property.checkAll
import java.util.zip.CRC32

/** Compares [Crc32] with Java's own CRC-32, which the exporter uses because it is faster there. */
class SameCrc32Spec : FunSpec({
    test("the page's checksum equals Java's, which the exporter writes, for any bytes") {
        checkAll(Arb.byteArray(Arb.int(0, 1000), Arb.byte())) { bytes ->
            Crc32().apply { update(bytes) }.value shouldBe CRC32().apply { update(bytes) }.value.toInt()
        }
    }
})
