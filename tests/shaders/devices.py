"""Runs compute shaders over arrays: SPIR-V by Vulkan, WGSL by wgpu."""

import subprocess
import sys

import numpy as np

INSTALL = "install it (on Debian and Ubuntu: apt-get install mesa-vulkan-drivers glslang-tools spirv-tools)"


def compiled(source, stage_arguments, folder, name):
    """The SPIR-V that glslang makes of a text, validated."""
    text, binary = folder / f"{name}.txt", folder / f"{name}.spv"
    text.write_text(source)
    try:
        command = ["glslangValidator", "-V", *stage_arguments, "-S", "comp", "-o", str(binary), str(text)]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stdout
        done = subprocess.run(["spirv-val", str(binary)], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr + done.stdout
    except FileNotFoundError as error:
        sys.exit(f"{error.filename} is not there, which test-shaders needs: {INSTALL}")
    return binary.read_bytes()


class Vulkan:
    """The first Vulkan device."""

    def __init__(self):
        """Take it, or end with a sentence."""
        try:
            import vulkan as vk
        except OSError:
            sys.exit(f"there is no Vulkan loader, which test-shaders needs: {INSTALL}")
        self.vk = vk
        # Kept: structures hold addresses, and not what they point to.
        self.kept = [vk.VkApplicationInfo(apiVersion=vk.VK_MAKE_VERSION(1, 1, 0))]
        try:
            instance = vk.vkCreateInstance(vk.VkInstanceCreateInfo(pApplicationInfo=self.kept[0]), None)
            devices = vk.vkEnumeratePhysicalDevices(instance)
        except vk.VkErrorIncompatibleDriver:
            devices = []
        if not devices:
            sys.exit(f"there is no Vulkan device, which test-shaders needs: {INSTALL}")
        self.physical = devices[0]
        self.name = vk.vkGetPhysicalDeviceProperties(self.physical).deviceName
        queue = vk.VkDeviceQueueCreateInfo(queueFamilyIndex=0, queueCount=1, pQueuePriorities=[1.0])
        self.kept.append(queue)
        self.device = vk.vkCreateDevice(self.physical, vk.VkDeviceCreateInfo(pQueueCreateInfos=[queue]), None)
        self.queue = vk.vkGetDeviceQueue(self.device, 0, 0)

    def _buffer(self, size):
        vk = self.vk
        info = vk.VkBufferCreateInfo(size=size, usage=vk.VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, sharingMode=0)
        buffer = vk.vkCreateBuffer(self.device, info, None)
        needs = vk.vkGetBufferMemoryRequirements(self.device, buffer)
        types = vk.vkGetPhysicalDeviceMemoryProperties(self.physical)
        wanted = vk.VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | vk.VK_MEMORY_PROPERTY_HOST_COHERENT_BIT
        index = next(
            i
            for i in range(types.memoryTypeCount)
            if needs.memoryTypeBits >> i & 1 and types.memoryTypes[i].propertyFlags & wanted == wanted
        )
        info = vk.VkMemoryAllocateInfo(allocationSize=needs.size, memoryTypeIndex=index)
        memory = vk.vkAllocateMemory(self.device, info, None)
        vk.vkBindBufferMemory(self.device, buffer, memory, 0)
        return buffer, memory

    def pipeline(self, spirv):
        """Compile a shader with two buffers; give their layout, the pipeline's, and the pipeline."""
        vk = self.vk
        bindings = [
            vk.VkDescriptorSetLayoutBinding(
                binding=i,
                descriptorType=vk.VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                descriptorCount=1,
                stageFlags=vk.VK_SHADER_STAGE_COMPUTE_BIT,
            )
            for i in range(2)
        ]
        layout = vk.vkCreateDescriptorSetLayout(
            self.device, vk.VkDescriptorSetLayoutCreateInfo(pBindings=bindings), None
        )
        pipeline_layout = vk.vkCreatePipelineLayout(
            self.device, vk.VkPipelineLayoutCreateInfo(pSetLayouts=[layout]), None
        )
        module = vk.vkCreateShaderModule(
            self.device, vk.VkShaderModuleCreateInfo(codeSize=len(spirv), pCode=spirv), None
        )
        name = "main"
        stage = vk.VkPipelineShaderStageCreateInfo(
            stage=vk.VK_SHADER_STAGE_COMPUTE_BIT, module=module, pName=name
        )
        info = vk.VkComputePipelineCreateInfo(stage=stage, layout=pipeline_layout)
        pipeline = vk.vkCreateComputePipelines(self.device, None, 1, [info], None)[0]
        return layout, pipeline_layout, pipeline

    def run(self, spirv, records, outputs):
        """Run a shader that reads binding 0 and writes binding 1, of so many numbers a record."""
        vk = self.vk
        count = len(records)
        sizes = records.nbytes, 4 * outputs * count
        (source, source_memory), (target, target_memory) = map(self._buffer, sizes)
        mapped = vk.vkMapMemory(self.device, source_memory, 0, sizes[0], 0)
        mapped[:] = records.tobytes()
        vk.vkUnmapMemory(self.device, source_memory)

        layout, pipeline_layout, pipeline = self.pipeline(spirv)
        size = vk.VkDescriptorPoolSize(type=vk.VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, descriptorCount=2)
        pool = vk.vkCreateDescriptorPool(
            self.device, vk.VkDescriptorPoolCreateInfo(maxSets=1, pPoolSizes=[size]), None
        )
        descriptors = vk.vkAllocateDescriptorSets(
            self.device, vk.VkDescriptorSetAllocateInfo(descriptorPool=pool, pSetLayouts=[layout])
        )[0]
        infos = [
            [vk.VkDescriptorBufferInfo(buffer=buffer, offset=0, range=size)]
            for buffer, size in zip((source, target), sizes, strict=True)
        ]
        writes = [
            vk.VkWriteDescriptorSet(
                dstSet=descriptors,
                dstBinding=i,
                descriptorType=vk.VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                pBufferInfo=infos[i],
            )
            for i in range(2)
        ]
        vk.vkUpdateDescriptorSets(self.device, 2, writes, 0, None)
        commands_pool = vk.vkCreateCommandPool(
            self.device, vk.VkCommandPoolCreateInfo(queueFamilyIndex=0), None
        )
        commands = vk.vkAllocateCommandBuffers(
            self.device,
            vk.VkCommandBufferAllocateInfo(
                commandPool=commands_pool, level=vk.VK_COMMAND_BUFFER_LEVEL_PRIMARY, commandBufferCount=1
            ),
        )[0]
        vk.vkBeginCommandBuffer(commands, vk.VkCommandBufferBeginInfo())
        vk.vkCmdBindPipeline(commands, vk.VK_PIPELINE_BIND_POINT_COMPUTE, pipeline)
        vk.vkCmdBindDescriptorSets(
            commands, vk.VK_PIPELINE_BIND_POINT_COMPUTE, pipeline_layout, 0, 1, [descriptors], 0, None
        )
        vk.vkCmdDispatch(commands, -(-count // 64), 1, 1)
        vk.vkEndCommandBuffer(commands)
        submit = vk.VkSubmitInfo(pCommandBuffers=[commands])
        vk.vkQueueSubmit(self.queue, 1, [submit], None)
        vk.vkQueueWaitIdle(self.queue)
        mapped = vk.vkMapMemory(self.device, target_memory, 0, sizes[1], 0)
        result = np.frombuffer(bytes(mapped), np.float32).reshape(count, outputs).copy()
        vk.vkUnmapMemory(self.device, target_memory)
        for buffer, memory in (source, source_memory), (target, target_memory):
            vk.vkDestroyBuffer(self.device, buffer, None)
            vk.vkFreeMemory(self.device, memory, None)
        return result


def run_wgsl(source, records, outputs):
    """The same for WGSL."""
    from wgpu.utils.compute import compute_with_buffers

    count = len(records)
    result = compute_with_buffers(
        {0: records.tobytes()}, {1: (count * outputs, "f")}, source, n=(-(-count // 64), 1, 1)
    )[1]
    return np.frombuffer(result, np.float32).reshape(count, outputs).copy()
