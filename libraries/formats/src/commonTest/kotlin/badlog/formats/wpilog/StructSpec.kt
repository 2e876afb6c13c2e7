package badlog.formats.wpilog

import badlog.core.recording.Recording
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

/** The recording of a log in which entry `s` of struct S has this [payload]. */
private fun read(
    schema: String,
    payload: ByteArray,
    others: Map<String, String> = emptyMap(),
    type: String = "struct:S",
): Recording {
    val log = TestLog().start(1, "s", type).start(2, "/.schema/struct:S", "structschema").string(2, 0, schema)
    var id = 3
    for ((name, text) in others) log.start(id, "NT:/.schema/struct:$name", "structschema").string(id++, 0, text)
    return parseLog(log.record(1, 1000, payload).bytes)
}

/** Each topic of entry `s`, with its first sample. */
private fun values(recording: Recording): Map<String, Any> = recording.topics.filter { "schema" !in it.name }
    .associate { it.name to if (it.texts.size > 0) it.texts[0] else it.samples.firstOrNull() ?: "nothing" }

class StructSpec : FunSpec({
    test("each field is a topic, whatever its type") {
        val schema = "bool b; int8 c;uint8 d;int16 e;uint16 f;int32 g;uint32 h;" +
            "int64 i;uint64 j;float k;double l;float32 m;float64 n;"
        val payload = byteArrayOf(1, -1, -1) + number(-2, 2) + number(-2, 2) + number(-3, 4) + number(-3, 4) +
            number(-4, 8) + number(5, 8) + floats(0.5f) + doubles(1.5) + floats(2.5f) + doubles(3.5)
        values(read(schema, payload)) shouldBe mapOf(
            "s/b" to 1.0, "s/c" to -1.0, "s/d" to 255.0, "s/e" to -2.0, "s/f" to 65534.0, "s/g" to -3.0, "s/h" to 4294967293.0,
            "s/i" to -4.0, "s/j" to 5.0, "s/k" to 0.5, "s/l" to 1.5, "s/m" to 2.5, "s/n" to 3.5,
        )
    }

    test("structs in structs, arrays in structs and texts are taken apart") {
        val others = mapOf("P" to "double x; Q q", "Q" to "int8 v[2]")
        val payload = byteArrayOf(7) + doubles(1.0) + byteArrayOf(1, 2) + doubles(2.0) + byteArrayOf(3, 4) +
            "abc".encodeToByteArray() + byteArrayOf(0, 0)
        values(read("uint8 n; P p[2]; char name[5]", payload, others)) shouldBe mapOf(
            "s/n" to 7.0,
            "s/p[0]/x" to 1.0,
            "s/p[0]/q/v[0]" to 1.0,
            "s/p[0]/q/v[1]" to 2.0,
            "s/p[1]/x" to 2.0,
            "s/p[1]/q/v[0]" to 3.0,
            "s/p[1]/q/v[1]" to 4.0,
            "s/name" to "abc",
        )
    }

    test("enumerations are texts, with the number where it has no name") {
        val schema = "enum {off=0, on = 1,} int8 a; {x=-1} int16 b; enum{} uint8 c"
        values(read(schema, byteArrayOf(1, -1, -1, 9))) shouldBe mapOf("s/a" to "on", "s/b" to "x", "s/c" to "9")
    }

    test("bit-fields of one width share bytes from the lowest bit on, and a bool joins any") {
        // int8: a in bits 0 to 3, b in 4 to 6, the bool in 7. Then c does not fit and takes the next byte.
        val schema = "int8 a:4; uint8 b:3; bool f:1; int8 c:4; int16 d:9; bool g:1; double e"
        val payload = byteArrayOf(0b1_101_1110.toByte(), 0b0111, (0x1FF and 0xFF).toByte(), 0b11) + doubles(2.0)
        values(read(schema, payload)) shouldBe mapOf(
            "s/a" to -2.0,
            "s/b" to 5.0,
            "s/f" to 1.0,
            "s/c" to 7.0,
            "s/d" to -1.0,
            "s/g" to 1.0,
            "s/e" to 2.0,
        )
    }

    test("arrays of structs have a number before the field") {
        val recording = read("double x; double y", doubles(1.0, 2.0, 3.0, 4.0), type = "struct:S[]")
        values(recording) shouldBe mapOf("s[0]/x" to 1.0, "s[0]/y" to 2.0, "s[1]/x" to 3.0, "s[1]/y" to 4.0)
    }

    test("records before their schema wait for it, even to the end of the file") {
        val log = TestLog().start(1, "s", "struct:S").record(1, 1, doubles(1.0)).record(1, 2, doubles(2.0))
            .start(2, "/.schema/struct:S", "structschema").string(2, 3, "double x")
        parseLog(log.bytes).topics.first { it.name == "s/x" }.samples.toList() shouldBe listOf(1.0, 2.0)
        parseLog(log.record(1, 4, doubles(3.0)).bytes).topics.first { it.name == "s/x" }.samples.toList() shouldBe
            listOf(1.0, 2.0, 3.0)
    }

    test("with a schema that is invalid, endless or huge, only sizes are read") {
        val senseless = listOf("double", "double x y", "foo x", "S again", "double x[99999999]", "double x:3", "int8 a:9")
        for (schema in senseless + listOf("int8 x[", "enum {a=1 int8 b")) {
            values(read(schema, doubles(1.0))) shouldBe mapOf("s" to 8.0)
        }
        values(read("double x", doubles(1.0) + 1)) shouldBe mapOf("s/x" to "nothing")
    }
})
