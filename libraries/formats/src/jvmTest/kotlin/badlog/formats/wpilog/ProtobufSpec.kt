package badlog.formats.wpilog

import badlog.core.recording.Topic
import com.google.protobuf.ByteString
import com.google.protobuf.DescriptorProtos.DescriptorProto
import com.google.protobuf.DescriptorProtos.EnumDescriptorProto
import com.google.protobuf.DescriptorProtos.EnumValueDescriptorProto
import com.google.protobuf.DescriptorProtos.FieldDescriptorProto
import com.google.protobuf.DescriptorProtos.FileDescriptorProto
import com.google.protobuf.Descriptors.EnumValueDescriptor
import com.google.protobuf.Descriptors.FieldDescriptor
import com.google.protobuf.Descriptors.FileDescriptor
import com.google.protobuf.DynamicMessage
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.long
import io.kotest.property.checkAll
import kotlin.random.Random

/** A message with a field of each type, a list of each type, and both again in messages inside. */
private val FILE: FileDescriptorProto = run {
    val types = FieldDescriptorProto.Type.entries - FieldDescriptorProto.Type.TYPE_GROUP
    fun DescriptorProto.Builder.addFields(inner: String?) = apply {
        var number = 1
        for (label in listOf(FieldDescriptorProto.Label.LABEL_OPTIONAL, FieldDescriptorProto.Label.LABEL_REPEATED)) {
            for (type in types) {
                val isMessage = type == FieldDescriptorProto.Type.TYPE_MESSAGE
                if (isMessage && inner == null) continue
                val field = FieldDescriptorProto.newBuilder().setName("f$number").setNumber(number++).setType(type).setLabel(label)
                if (isMessage) field.setTypeName(".t.$inner")
                if (type == FieldDescriptorProto.Type.TYPE_ENUM) field.setTypeName(".t.Mode")
                addField(field)
            }
        }
    }
    fun value(name: String, number: Int) = EnumValueDescriptorProto.newBuilder().setName(name).setNumber(number)
    FileDescriptorProto.newBuilder().setName("t.proto").setPackage("t").setSyntax("proto3")
        .addEnumType(EnumDescriptorProto.newBuilder().setName("Mode").addValue(value("NONE", 0)).addValue(value("AUTO", 1)).addValue(value("BELOW", -2)))
        .addMessageType(DescriptorProto.newBuilder().setName("Inner").addFields(null))
        .addMessageType(DescriptorProto.newBuilder().setName("Outer").addFields("Inner"))
        .build()
}
private val DESCRIPTORS = FileDescriptor.buildFrom(FILE, emptyArray())

private fun Random.value(field: FieldDescriptor): Any = when (field.javaType!!) {
    FieldDescriptor.JavaType.INT -> nextInt()
    FieldDescriptor.JavaType.LONG -> nextLong(-(1L shl 53), 1L shl 53)
    FieldDescriptor.JavaType.FLOAT -> nextFloat()
    FieldDescriptor.JavaType.DOUBLE -> nextDouble()
    FieldDescriptor.JavaType.BOOLEAN -> nextBoolean()
    FieldDescriptor.JavaType.STRING -> "text ${nextInt(100)}"
    FieldDescriptor.JavaType.BYTE_STRING -> ByteString.copyFrom(nextBytes(nextInt(5)))
    FieldDescriptor.JavaType.ENUM -> field.enumType.values.random(this)
    FieldDescriptor.JavaType.MESSAGE -> message(field.messageType.name)
}

private fun Random.message(name: String): DynamicMessage {
    val builder = DynamicMessage.newBuilder(DESCRIPTORS.findMessageTypeByName(name))
    for (field in builder.descriptorForType.fields) {
        if (field.isRepeated) {
            repeat(nextInt(3)) { builder.addRepeatedField(field, value(field)) }
        } else if (nextInt(4) > 0) {
            builder.setField(field, value(field))
        }
    }
    return builder.build()
}

/** The values of [message], as Google's library reads them, by the names of their topics. */
private fun valuesOf(message: DynamicMessage, path: String): Map<String, Any> = buildMap {
    fun add(name: String, value: Any, field: FieldDescriptor) {
        when (value) {
            is DynamicMessage -> putAll(valuesOf(value, name))
            is ByteString -> put(name, value.size().toDouble())
            is EnumValueDescriptor -> put(name, value.name)
            is Boolean -> put(name, if (value) 1.0 else 0.0)
            is Int -> put(name, if (field.type.name.contains("UINT") || field.type.name == "FIXED32") value.toUInt().toDouble() else value.toDouble())
            is Long -> put(name, if (field.type.name.contains("UINT") || field.type.name == "FIXED64") value.toULong().toDouble() else value.toDouble())
            is Number -> put(name, value.toDouble())
            else -> put(name, value)
        }
    }
    for (field in message.descriptorForType.fields) {
        val name = "$path/${field.name}"
        when {
            field.isRepeated -> (message.getField(field) as List<*>).forEachIndexed { i, value -> add("$name[$i]", checkNotNull(value), field) }
            field.javaType != FieldDescriptor.JavaType.MESSAGE || message.hasField(field) -> add(name, message.getField(field), field)
        }
    }
}

private fun valueOf(topic: Topic): Any? = if (topic.texts.size > 0) topic.texts[0] else topic.samples.firstOrNull()?.takeUnless { it.isNaN() }

internal class ProtobufSpec : FunSpec({
    test("every message is read as Google's library for Protocol Buffers reads it") {
        checkAll(Arb.long()) { seed ->
            val written = Random(seed).message("Outer").toByteArray()
            val log = TestLog().start(1, "m", "proto:t.Outer").start(2, "/.schema/proto:t.proto", "proto:FileDescriptorProto")
                .record(2, 0, FILE.toByteArray()).record(1, 1000, written)
            val topics = parseLog(log.bytes).topics.filter { it.name.startsWith("m/") }
            val read = topics.mapNotNull { topic -> valueOf(topic)?.let { topic.name to it } }.toMap()
            read shouldBe valuesOf(DynamicMessage.parseFrom(DESCRIPTORS.findMessageTypeByName("Outer"), written), "m")
        }
    }
})
